// SPDX-License-Identifier: MIT
// LANES rays against one cylinder at a time of a block. One width; no guard.

/// Returns the rays that are left: those that have just left a cylinder of the block inwards.
FN maskw cylinder_packet_w(Packet_w* p, GLOBAL const real* block, GLOBAL const int* ids, int slot, int kind,
                           maskw active) {
  maskw left = none_w();
  for (uint prims = bits_w(is_there_w(ids)); prims != 0u; prims &= prims - 1u) {
    int i = first_bit(prims);
    GLOBAL const real* prim = block + i;
    maskw which = active;
    if (p->has_departed) {
      maskw departed = packet_departed_w(p, ids[i]);
      left = left | (active & departed & ~p->outward);
      which = which & ~departed;
    }
#if TIER_ROBUST
    which = which & near_ball_w(p, ball_around_w(prim, kind));
#endif
    if (!any_w(which)) continue;
    Cylinders_w cylinder;
    cylinder.foot = splat3_w(vec3(prim[0], prim[LANES], prim[2 * LANES]));
    cylinder.axis = splat3_w(vec3(prim[3 * LANES], prim[4 * LANES], prim[5 * LANES]));
    cylinder.length = splat_w(prim[6 * LANES]);
    cylinder.r = splat_w(prim[7 * LANES]);
    CylinderHits_w hits = cylinder_hits_w(p->o, p->d, &cylinder, p->t_min, which, none_w());
    realw t = cylinder_t_w(p->o, p->d, &cylinder, &hits, none_w());
    maskw hit = hits.which & le_w(p->t_min, t) & le_w(t, p->t);
    if (any_w(hit)) packet_take_w(p, hit, t, splat_int_w(ids[i]), splat_int_w(kind), splat_int_w(slot + i));
  }
  return left;
}
