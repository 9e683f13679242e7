// SPDX-License-Identifier: MIT
// Fresnel's equations for dielectrics and unpolarised light, in lanes, in a form without cancellation: with c the
// cosine on the near side and g = eta cos(theta_t), g^2 = c^2 + eta^2 - 1 and g - c = (eta^2 - 1) / (g + c). R. Cook,
// K. Torrance, "A Reflectance Model for Computer Graphics", ACM TOG 1(1), 1982, has R by c and g. One width; no guard.

typedef struct {
  realw reflectance;    ///< Within [0, 1]; 1 under total reflection.
  realw transmittance;  ///< One less that, as a product: to a few roundings of its own, however little goes through.
  realw cosine;         ///< Of the transmitted direction against the normal of the far side; 0 under total reflection.
} Fresnel_w;

/// c^2 + eta^2 - 1 to about one rounding, even near the critical angle: the squares and sums keep their rounding errors
/// (T. Dekker, "A Floating-Point Technique for Extending the Available Precision", 1971; D. Knuth's sum).
FN realw fresnel_square_w(realw c, realw eta) {
  realw one = splat_w(R(1.0)), p = eta * eta, q = c * c;
  realw rest = fma_w(eta, eta, -p) + fma_w(c, c, -q);
  realw h = p - one, of_one = h - p, rest_h = (p - (h - of_one)) - (one + of_one);
  realw s = h + q, of_q = s - h, rest_s = (h - (s - of_q)) + (q - of_q);
  return s + (rest_s + (rest_h + rest));
}

/// c: cosine on the near side, within [0, 1]; eta: index of refraction of the far side over that of the near one.
/// Finite for all of them, the critical angle and grazing light included; equal indices reflect nothing at any angle.
FN Fresnel_w fresnel_w(realw c, realw eta) {
  Fresnel_w f;
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), square = fresnel_square_w(c, eta);
  maskw is_total = lt_w(square, zero), is_same = eq_w(eta, one);
  realw g = sqrt_w(sel_w(is_total, zero, square)), sum = g + c;
  maskw is_grazing = le_w(sum, zero);  // Not of equal indices, but for rounding: c so small that its square is 0.
  sum = sel_w(is_grazing, one, sum);
  realw difference = (eta - one) * (eta + one) / sum;
  realw across = difference / sum, ratio = fma_w(c, sum, -one) / fma_w(c, difference, one);
  realw reflectance = splat_w(R(0.5)) * (across * across) * fma_w(ratio, ratio, one);
  reflectance = sel_w(is_total | is_grazing | lt_w(one, reflectance), one, reflectance);
  f.reflectance = sel_w(is_same, zero, reflectance);
  f.cosine = sel_w(is_same, c, g / eta);
  realw along = fma_w(eta * eta, c, g), by_s = one / sum, by_p = eta / sel_w(is_total | is_grazing, one, along);
  realw transmittance = splat_w(R(2.0)) * c * g * fma_w(by_s, by_s, by_p * by_p);
  f.transmittance = sel_w(is_same, one, sel_w(is_total | is_grazing, zero, min_w(transmittance, one)));
  return f;
}
