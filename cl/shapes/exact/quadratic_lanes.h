// SPDX-License-Identifier: MIT
// Roots of a t^2 + 2 b t + c in double words, one width; no guard. Neither root is a difference of nearly equal
// numbers: q = -(b + sgn(b) sqrt(D)), roots q / a and c / q (W. H. Press et al., Numerical Recipes, 3rd ed., 2007,
// section 5.6).

typedef struct {
  dw_w near, far;
} Roots_w;

/// d = b^2 - a c, computed in the most accurate form; the result is undefined where d < 0.
FN Roots_w quadratic_roots_w(dw_w a, dw_w b, dw_w c, dw_w d) {
  dw_w s = dw_sqrt_w(d);
  // A compare, not the sign bit: some devices lose the sign of a zero b.
  s = dw_sel_w(lt_w(b.hi, splat_w(R(0.0))), dw_negate_w(s), s);
  dw_w q = dw_negate_w(dw_add_w(b, s));
  dw_w t0 = dw_div_w(q, a), t1 = dw_div_w(c, q);
  // b = D = 0: both roots are 0, and c / q is 0 / 0.
  t1 = dw_sel_w(eq_w(q.hi, splat_w(R(0.0))), t0, t1);
  maskw second_first = lt_w(t1.hi, t0.hi);
  Roots_w roots;
  roots.near = dw_sel_w(second_first, t1, t0);
  roots.far = dw_sel_w(second_first, t0, t1);
  return roots;
}
