// SPDX-License-Identifier: MIT
// LANES rays against one disk at a time of a block. One width; no guard.

FN void disk_packet_w(Packet_w* p, GLOBAL const real* block, GLOBAL const int* ids, int slot, int kind, maskw active) {
  for (uint prims = bits_w(is_there_w(ids)); prims != 0u; prims &= prims - 1u) {
    int i = first_bit(prims);
    GLOBAL const real* prim = block + i;
    maskw which = active;
    if (p->has_departed) which = which & ~packet_departed_w(p, ids[i]);
#if TIER_ROBUST
    which = which & near_ball_w(p, ball_around_w(prim, kind));
#endif
    if (!any_w(which)) continue;
    Disks_w disk;
    disk.center = splat3_w(vec3(prim[0], prim[LANES], prim[2 * LANES]));
    disk.normal = splat3_w(vec3(prim[3 * LANES], prim[4 * LANES], prim[5 * LANES]));
    disk.r2 = splat_w(prim[6 * LANES]);
    realw t = disk_t_w(p->o, p->d, &disk, p->t_min, p->t, &which);
    which = which & le_w(p->t_min, t) & le_w(t, p->t);
    if (any_w(which)) packet_take_w(p, which, t, splat_int_w(ids[i]), splat_int_w(kind), splat_int_w(slot + i));
  }
}
