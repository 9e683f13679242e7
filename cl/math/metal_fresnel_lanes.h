// SPDX-License-Identifier: MIT
// Fresnel's equations for light that meets a conductor from a medium that absorbs nothing, unpolarised, in lanes. With
// complex index n + i k and c, s the cosine and sine of incidence, let (a + i b)^2 = (n + i k)^2 - s^2 (M. Born,
// E. Wolf, "Principles of Optics", 1999, section 14.2):
//   R_s = ((a - c)^2 + b^2) / ((a + c)^2 + b^2)
//   R_p = R_s ((a c - s^2)^2 + (b c)^2) / ((a c + s^2)^2 + (b c)^2)
// All are sums of squares. Of a^2 and b^2 the larger one is a sum of what is positive, the smaller one follows from
// a b = n k. a - c is the quotient of a^2 - c^2 = n^2 - 1 - k^2 + b^2 and a + c, so that indices near 1 keep their
// digits. One width; no guard.

/// Of one channel. c: within [0, 1]. A conductor with n = 0 reflects everything, and so does any at grazing incidence.
FN realw metal_reflectance_w(realw c, realw n, realw k) {
  realw zero = splat_w(R(0.0)), one = splat_w(R(1.0)), half_one = splat_w(R(0.5));
  realw k2 = k * k, product = n * k, s2 = (one - c) * (one + c);
  realw difference = fresnel_square_w(c, n) - k2, twice = product + product;  // a^2 - b^2; 2 a b
  realw larger = half_one * (abs_w(difference) + sqrt_w(fma_w(difference, difference, twice * twice)));
  realw smaller = sel_w(lt_w(zero, larger), product * (product / larger), zero);
  maskw is_a_larger = lt_w(zero, difference);
  realw a = sqrt_w(sel_w(is_a_larger, larger, smaller)), b2 = sel_w(is_a_larger, smaller, larger);
  maskw is_total = le_w(c, zero) | eq_w(n, zero);
  realw sum = sel_w(is_total, one, a + c), less = (fma_w(n - one, n + one, -k2) + b2) / sum;
  realw across = fma_w(less, less, b2) / fma_w(sum, sum, b2);
  realw ac = a * c, bc2 = b2 * c * c, below = ac + s2, above = ac - s2;
  realw ratio = fma_w(above, above, bc2) / sel_w(is_total, one, fma_w(below, below, bc2));
  realw reflectance = half_one * across * (one + ratio);
  return sel_w(is_total | lt_w(one, reflectance), one, reflectance);
}

/// Of three channels: eta the real parts of the indices, k the imaginary ones.
SELDOM_FN real3w metal_reflectances_w(realw c, real3w eta, real3w k) {
  return vec3_w(metal_reflectance_w(c, eta.x, k.x), metal_reflectance_w(c, eta.y, k.y),
                metal_reflectance_w(c, eta.z, k.z));
}
