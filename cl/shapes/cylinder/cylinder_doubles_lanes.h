// SPDX-License-Identifier: MIT
// What doubles tell for certain of open cylinders, on devices that have them: a tenth of the operations of double
// words, which cylinder_robust_lanes.h decides by on every device. Where a number is nearer to its limit than double
// words are off, or a few times that, nothing is told; so the bits are those of double words. One width; no guard.

typedef struct {
  maskw hit, told;  ///< Lanes that are hit; lanes of which that is certain.
  maskw is_near;    ///< t is the near root.
  wide_w t;
  realw a, chord;  ///< |d x v|^2, half the chord.
} ToldCylinders_w;

/// p x q of a real vector q, within 2 roundings of the sums of absolute values.
FN wide3_w wide_cross_w(wide3_w p, real3w q) {
  wide3_w c;
  c.x = wide_subtract_w(wide_scale_w(p.y, q.z), wide_scale_w(p.z, q.y));
  c.y = wide_subtract_w(wide_scale_w(p.z, q.x), wide_scale_w(p.x, q.z));
  c.z = wide_subtract_w(wide_scale_w(p.x, q.y), wide_scale_w(p.y, q.x));
  return c;
}

/// The lanes of `which`, as cylinder_block computes them. Norms are sums of absolute values, F = |f| + r. Double words
/// have a r^2 - (f.(d x v))^2 within 2^-40 (|d| |v| F)^2, and t within cylinder_off; with four times that, and what
/// rounding to a real moves t by, a place along the axis is off by 2^-38 |v| (F + |d| |t| + |v| length) and |d| |v|
/// times that of t.
FN ToldCylinders_w cylinders_told_w(real3w o, real3w d, realw t_min, const Cylinders_w* c, maskw which) {
  real3w foot = c->foot, v = c->v;
  realw length = c->length, r = c->r, zero = splat_w(R(0.0));
  wide3_w f = wide_difference3_w(o, foot), from = wide_cross_w(f, v), wide_d;
  wide_d.x = wide_of_w(d.x);
  wide_d.y = wide_of_w(d.y);
  wide_d.z = wide_of_w(d.z);
  wide3_w across = wide_cross_w(wide_d, v);
  wide_w a = wide_dot3_w(across, across), b = wide_dot3_w(from, across), apart = wide_dot3_w(f, across);
  wide_w v2 = wide_add_w(wide_add_w(wide_product_w(v.x, v.x), wide_product_w(v.y, v.y)), wide_product_w(v.z, v.z));
  wide_w r2 = wide_product_w(r, r), at_o = wide_subtract_w(wide_dot3_w(from, from), wide_multiply_w(r2, v2));
  wide_w inside = wide_subtract_w(wide_multiply_w(a, r2), wide_multiply_w(apart, apart));

  realw size_d = size1_w(d), size_v = size1_w(v), size_f = size1_w(sub3_w(o, foot)) + r;
  realw norm = size_d * size_v * size_f, unsure = splat_w(R(0x1p-38)) * norm * norm, m = narrow_w(inside);
  maskw in_scale = lt_w(splat_w(R(0x1p-40)), norm) & lt_w(norm, splat_w(R(0x1p+60)));
  maskw meets = in_scale & lt_w(unsure, m), misses = in_scale & lt_w(m, -unsure);

  wide_w root = wide_root_w(wide_multiply_w(v2, inside));
  root = wide_sel_w(lt_w(narrow_w(b), zero), wide_negate_w(root), root);
  wide_w q = wide_negate_w(wide_add_w(b, root)), t0 = wide_divide_w(q, a), t1 = wide_divide_w(at_o, q);
  maskw swapped = lt_w(narrow_w(t1), narrow_w(t0));
  wide_w near = wide_sel_w(swapped, t1, t0), far = wide_sel_w(swapped, t0, t1);
  wide_w o_along = wide_dot_w(f, v), d_along = wide_dot_w(wide_d, v), end = wide_scale_w(v2, length);

  ToldCylinders_w told;
  told.a = narrow_w(a);
  told.chord = abs_w(narrow_w(root)) / told.a;
  realw largest = max_w(abs_w(narrow_w(t0)), abs_w(narrow_w(t1)));
  realw t_off = splat_w(R(4.0)) * cylinder_off_w(o, c, largest, told.a, told.chord, splat_w(DOUBLE_WORD_ROUNDOFF));
  t_off = fma_w(splat_w(R(0x1p-22)), largest, t_off);
  realw place = fma_w(size_d, largest, fma_w(size_v, length, size_f));
  realw off = size_v * fma_w(splat_w(R(0x1p-38)), place, size_d * t_off);

  wide_w near_along = wide_add_w(o_along, wide_multiply_w(near, d_along));
  wide_w far_along = wide_add_w(o_along, wide_multiply_w(far, d_along));
  realw near_after = narrow_w(wide_subtract_w(near, wide_of_w(t_min)));
  realw near_left = narrow_w(wide_subtract_w(end, near_along)), far_left = narrow_w(wide_subtract_w(end, far_along));
  realw near_place = narrow_w(near_along), far_place = narrow_w(far_along);
  maskw is_near = lt_w(t_off, near_after) & lt_w(off, near_place) & lt_w(off, near_left);
  maskw is_not = lt_w(near_after, -t_off) | lt_w(near_place, -off) | lt_w(near_left, -off);
  maskw is_far = lt_w(off, far_place) & lt_w(off, far_left);
  maskw is_none = lt_w(far_place, -off) | lt_w(far_left, -off);
  told.is_near = is_near;
  told.hit = which & meets & (is_near | (is_not & is_far));
  told.told = misses | (meets & (is_near | (is_not & (is_far | is_none))));
  told.t = wide_sel_w(is_near, near, far);
  return told;
}
