// SPDX-License-Identifier: MIT
// t = n.(p - o) / (n.d), correctly rounded, a ray and a plane a lane. Parallel rays, those in the plane included, have
// a NaN. One width; no guard.

/// A range that the correctly rounded t certainly lies in, mostly a single number; NaN where nothing is known. S: the
/// sum of absolute values of a dot product. Doubles, w = 2^-53: numerator and denominator are within 5 w S and 4 w S'.
/// Single precision, u = 2^-24: three-fold sums are within 2 u^2 of themselves and 1728 u^3 S, 216 u^3 S'
/// (double_word.h); 2^-80 in S is 2^4 times what underflow does to them.
FN void plane_range_w(real3w o, real3w d, real3w p, real3w n, PRIVATE realw* least, PRIVATE realw* most) {
  real3w g = sub3_w(p, o);
  realw tiny = splat_w(R(0x1p-80));
  realw s = fma_w(abs_w(n.z), abs_w(g.z), fma_w(abs_w(n.y), abs_w(g.y), fma_w(abs_w(n.x), abs_w(g.x), tiny)));
  realw s_d = fma_w(abs_w(n.z), abs_w(d.z), fma_w(abs_w(n.y), abs_w(d.y), fma_w(abs_w(n.x), abs_w(d.x), tiny)));
#if WIDE_IS_DOUBLE
  wide_w n_d = wide_add_w(wide_add_w(wide_product_w(n.x, d.x), wide_product_w(n.y, d.y)), wide_product_w(n.z, d.z));
  wide_w t = wide_divide_w(wide_dot_w(wide_difference3_w(p, o), n), n_d);
  realw lost = splat_w(R(16.0) * WIDE_ROUNDOFF), rounded = splat_w(R(0.0));
#else
  dw_w n_d = real_dot_real3_w(n.x, n.y, n.z, d.x, d.y, d.z);
  dw_w t = dw_div_w(dot_real3_w(two_difference3_w(p.x, p.y, p.z, o.x, o.y, o.z), n.x, n.y, n.z), n_d);
  realw lost = splat_w(R(0x1p-16) * DOUBLE_WORD_ROUNDOFF), rounded = splat_w(R(2.0) * DOUBLE_WORD_ROUNDOFF);
#endif
  realw size = abs_w(narrow_w(t)), across = abs_w(narrow_w(n_d));
  realw off = fma_w(lost, fma_w(size, s_d, s) / across, fma_w(rounded, size, splat_w(R(0x1p-120))));
  maskw is_known = lt_w(splat_w(R(4.0)) * lost * s_d, across);
  wide_range_w(t, off, is_known, least, most);
}

/// t of the lanes of `open`, from its range; of the others as it is.
SELDOM_FN realw plane_decided_w(PRIVATE const real3w* o, PRIVATE const real3w* d, PRIVATE const real3w* p,
                                PRIVATE const real3w* n, PRIVATE const realw* least, PRIVATE const realw* most,
                                uint open) {
  realw t = *least;
  ExactCase one;
  one.c = vec3(R(0.0), R(0.0), R(0.0));
  one.r = R(0.0);
  for (; open != 0u; open &= open - 1u) {
    int i = first_bit(open);
    one.o = get3_w(o, i);
    one.d = get3_w(d, i);
    one.a = get3_w(p, i);
    one.b = get3_w(n, i);
    put_w(&t, i, exact_plane_t(&one, get_w(least, i), get_w(most, i)));
  }
  return t;
}

/// t of the lanes of `which` where it may lie in t_min ... t_max; others are undefined.
FN realw plane_t_w(real3w o, real3w d, real3w p, real3w n, realw t_min, realw t_max, maskw which) {
  realw least, most;
  plane_range_w(o, d, p, n, &least, &most);
  maskw open = which & ~(eq_w(least, most) | lt_w(most, t_min) | lt_w(t_max, least));
  if (!any_w(open)) return least;
  return plane_decided_w(&o, &d, &p, &n, &least, &most, bits_w(open));
}
