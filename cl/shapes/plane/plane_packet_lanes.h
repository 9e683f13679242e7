// SPDX-License-Identifier: MIT
// LANES rays against one plane at a time of a block: plane_lanes.h with the roles exchanged, the same operations. One
// width; no guard.

FN void plane_packet_w(Packet_w* p, GLOBAL const real* block, GLOBAL const int* ids, int slot, int kind, maskw active) {
  for (uint prims = bits_w(nonzero_w(load_int_w(ids) - splat_int_w(-1))); prims != 0u; prims &= prims - 1u) {
    int i = first_bit(prims);
    GLOBAL const real* prim = block + i;
    maskw which = p->has_departed ? active & ~packet_departed_w(p, ids[i]) : active;
    realw px = splat_w(prim[0]), py = splat_w(prim[LANES]), pz = splat_w(prim[2 * LANES]);
    realw nx = splat_w(prim[3 * LANES]), ny = splat_w(prim[4 * LANES]), nz = splat_w(prim[5 * LANES]);
#if TIER_ROBUST
    real3w anchor = vec3_w(px, py, pz), normal = vec3_w(nx, ny, nz);
    realw t = plane_t_w(p->o, p->d, anchor, normal, p->t_min, p->t, which);
#elif TIER_COMPENSATED
    dw3_w g = two_difference3_w(px, py, pz, p->o.x, p->o.y, p->o.z);
    dw_w n_d = real_dot_real3_w(nx, ny, nz, p->d.x, p->d.y, p->d.z);
    realw t = dw_div_w(dot_real3_w(g, nx, ny, nz), n_d).hi;
#elif TIER_FAST
    realw hesse = nx * px + ny * py + nz * pz, height = nx * p->o.x + ny * p->o.y + nz * p->o.z;
    realw t = (hesse - height) / (nx * p->d.x + ny * p->d.y + nz * p->d.z);
#else
    realw numerator = fma_w(nz, pz - p->o.z, fma_w(ny, py - p->o.y, nx * (px - p->o.x)));
    realw t = numerator / fma_w(nz, p->d.z, fma_w(ny, p->d.y, nx * p->d.x));
#endif
    maskw hit = which & le_w(p->t_min, t) & le_w(t, p->t);
    if (any_w(hit)) packet_take_w(p, hit, t, splat_int_w(ids[i]), splat_int_w(kind), splat_int_w(slot + i));
  }
}
