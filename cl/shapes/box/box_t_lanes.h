// SPDX-License-Identifier: MIT
// t of boxes that are hit, correctly rounded, one width; no guard: the largest entry, or the smallest exit. Rounding
// keeps order, so that is the largest or smallest of the rounded ones.

SELDOM_FN realw boxes_decided_w(const Ray* ray, GLOBAL const real* block, uint open, uint departed, realw t) {
  for (; open != 0u; open &= open - 1u) {
    int i = first_bit(open);
    put_w(&t, i, box_exact_t(ray, block + i, LANES, (int)(departed >> i & 1u)));
  }
  return t;
}

/// t: as computed, each quotient within 1.5 u of itself. which: lanes that are hit. Sure: where the one quotient is far
/// enough from the others, and its remainder, a double word within 2^-46 of t, from a midpoint. Where numbers are so
/// small that underflow loses digits of the remainder nothing is sure.
FN realw box_t_w(const Ray* ray, GLOBAL const real* block, maskw which, maskw departed, realw t, real3w entries,
                 real3w exits) {
  realw enter = max_w(entries.z, max_w(entries.y, max_w(entries.x, splat_w(-REAL_MAX))));
  maskw is_entry = ~departed & eq_w(t, enter);
  real3w sides = sel3_w(is_entry, entries, exits);
  realw spare = splat_w(R(0x1p-21)) * abs_w(t);
  maskw is_x = eq_w(sides.x, t), is_y = eq_w(sides.y, t) & ~is_x, is_z = ~(is_x | is_y);
  int x = ray->near_x, y = ray->near_y, z = ray->near_z;
  realw plane_x = sel_w(is_entry, load_w(block + x * LANES), load_w(block + (x ^ 1) * LANES));
  realw plane_y = sel_w(is_entry, load_w(block + y * LANES), load_w(block + (y ^ 1) * LANES));
  realw plane_z = sel_w(is_entry, load_w(block + z * LANES), load_w(block + (z ^ 1) * LANES));
  realw plane = sel_w(is_x, plane_x, sel_w(is_y, plane_y, plane_z));
  realw o = sel_w(is_x, splat_w(ray->o.x), sel_w(is_y, splat_w(ray->o.y), splat_w(ray->o.z)));
  realw d = sel_w(is_x, splat_w(ray->d.x), sel_w(is_y, splat_w(ray->d.y), splat_w(ray->d.z)));
  dw_w way = two_sum_w(plane, -o);
  realw rest = (fma_w(-t, d, way.hi) + way.lo) / d,
        off = fma_w(splat_w(R(0.5) * DOUBLE_WORD_ROUNDOFF), abs_w(t), splat_w(R(0x1p-120)));
  realw least = t + (rest - off), most = t + (rest + off);
  maskw rivals = (le_w(abs_w(sides.x - t), spare) & ~is_x) | (le_w(abs_w(sides.y - t), spare) & ~is_y) |
                 (le_w(abs_w(sides.z - t), spare) & ~is_z) |
                 (le_w(abs_w(splat_w(ray->t_min) - enter), splat_w(R(0x1p-21)) * abs_w(enter)) & ~departed);
  maskw sure = eq_w(least, most) & ~rivals & lt_w(splat_w(R(0x1p-100)), abs_w(way.hi));
  maskw open = which & ~sure;
  if (!any_w(open)) return least;
  return boxes_decided_w(ray, block, bits_w(open), bits_w(departed), least);
}
