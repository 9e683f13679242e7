// SPDX-License-Identifier: MIT
// LANES rays against one disk at a time of a block: disk_block_w with the roles exchanged, the same operations. One
// width; no guard.
#define PACKET_DISKS disk_packet_w

FN void disk_packet_w(Packet_w* p, GLOBAL const real* block, GLOBAL const int* ids, int slot, int kind, maskw active) {
  for (uint prims = bits_w(is_there_w(ids)); prims != 0u; prims &= prims - 1u) {
    int i = first_bit(prims);
    GLOBAL const real* prim = block + i;
    maskw which = active;
    if (p->has_ends) which = which & ~(TIER_COMPENSATED ? packet_end_w(p, ids[i]) : packet_departed_w(p, ids[i]));
    real3w center = vec3_w(splat_w(prim[0]), splat_w(prim[LANES]), splat_w(prim[2 * LANES]));
    real3w n = vec3_w(splat_w(prim[3 * LANES]), splat_w(prim[4 * LANES]), splat_w(prim[5 * LANES]));
    real3w o = p->o, d = p->d;
    realw r2 = splat_w(prim[6 * LANES]);
#if TIER_ROBUST
    which = which & near_ball_w(p, disk_ball_w(prim));
    if (!any_w(which)) continue;
    maskw hit = disks_hit_w(o, d, center, n, r2, which);
    if (!any_w(hit)) continue;
    realw t = plane_t_w(o, d, center, n, p->t_min, p->t, hit);
#elif TIER_COMPENSATED
    maskw inside;
    realw t = disks_met_w(two_difference3_w(center.x, center.y, center.z, o.x, o.y, o.z), n, d, r2, &inside).hi;
    maskw hit = which & inside;
#elif TIER_FAST
    realw hesse = n.x * center.x + n.y * center.y + n.z * center.z;
    realw t = (hesse - (n.x * o.x + n.y * o.y + n.z * o.z)) / (n.x * d.x + n.y * d.y + n.z * d.z);
    realw px = o.x + t * d.x - center.x, py = o.y + t * d.y - center.y, pz = o.z + t * d.z - center.z;
    maskw hit = which & le_w(px * px + py * py + pz * pz, r2);
#else
    real3w g = sub3_w(center, o);
    realw t = fma_w(n.z, g.z, fma_w(n.y, g.y, n.x * g.x)) / fma_w(n.z, d.z, fma_w(n.y, d.y, n.x * d.x));
    realw px = fma_w(t, d.x, -g.x), py = fma_w(t, d.y, -g.y), pz = fma_w(t, d.z, -g.z);
    maskw hit = which & le_w(fma_w(pz, pz, fma_w(py, py, px * px)), r2);
#endif
    hit = hit & le_w(p->t_min, t) & le_w(t, p->t);
    if (any_w(hit)) packet_take_w(p, hit, t, splat_int_w(ids[i]), splat_int_w(kind), splat_int_w(slot + i));
  }
}
