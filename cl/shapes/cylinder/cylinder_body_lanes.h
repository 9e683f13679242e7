// SPDX-License-Identifier: MIT
// LANES rays against one open cylinder at a time of a block: what doubles tell for certain of them, robust tier, by the
// operations of cylinder_block_w. One width; no guard.
#define PACKET_CYLINDERS cylinder_packet_w

/// The rays of `active` that must be asked one by one: near cylinders of the block and not told for certain, or asked
/// for the other side of the one that they have left.
FN maskw cylinder_packet_w(Packet_w* p, GLOBAL const real* block, GLOBAL const int* ids, int slot, int kind,
                           maskw active) {
  (void)slot;
  (void)kind;
#if TIER_ROBUST
  maskw rest = none_w();
  for (uint prims = bits_w(is_there_w(ids)); prims != 0u; prims &= prims - 1u) {
    int i = first_bit(prims);
    GLOBAL const real* prim = block + i;
    Cylinders_w c;
    c.foot = vec3_w(splat_w(prim[0]), splat_w(prim[LANES]), splat_w(prim[2 * LANES]));
    c.v = vec3_w(splat_w(prim[3 * LANES]), splat_w(prim[4 * LANES]), splat_w(prim[5 * LANES]));
    c.length = splat_w(prim[6 * LANES]);
    c.r = splat_w(prim[7 * LANES]);
    maskw which = active & near_mantle_w(p->d, p->t_min, p->bound, sub3_w(p->o, c.foot), &c);
    if (p->has_ends) {
      maskw left = packet_departed_w(p, ids[i]);
      which = which & ~(left | ~nonzero_w(p->aim - splat_int_w(ids[i])));
      rest = rest | (active & left & ~p->outward);
    }
    if (!any_w(which)) continue;
#if WIDE_IS_DOUBLE
    ToldCylinders_w told = cylinders_told_w(p->o, p->d, p->t_min, &c, which);
    which = which & ~told.told;
    if (any_w(told.hit)) {
      realw t = narrow_w(told.t), off = cylinder_off_w(p->o, &c, t, told.a, told.chord, splat_w(WIDE_ROUNDOFF));
      maskw is_one = eq_w(wide_least_w(told.t, off), wide_most_w(told.t, off));
      which = which | (told.hit & ~is_one);
      maskw hit = told.hit & is_one & le_w(p->t_min, t) & le_w(t, p->t);
      if (any_w(hit)) packet_take_w(p, hit, t, splat_int_w(ids[i]), splat_int_w(kind), splat_int_w(slot + i));
    }
#endif
    rest = rest | which;
  }
  return rest;
#else
  (void)p;
  (void)block;
  (void)ids;
  return active;
#endif
}
