// SPDX-License-Identifier: MIT
// L. Henyey, J. Greenstein, "Diffuse radiation in the Galaxy", Astrophysical Journal 93, 1941: g is the mean cosine.
// 1 + g^2 - 2 g cos loses all digits in the peak of |g| near 1. It is (1 - |g|)^2 + 2 |g| (1 - cos), and 1 - cos is
// half the squared distance of the two ways; so both are computed here, and the drawn angle likewise. One width; no
// guard.

/// (1 - g^2) / (4 pi) over that to the power of 3/2. missing: 1 - cos, of g < 0 1 + cos.
FN realw hg_density_w(real g, realw missing) {
  real a = real_abs(g), rest = R(1.0) - a;
  realw squared = fma_w(splat_w(R(2.0) * a), missing, splat_w(rest * rest));
  return splat_w(R(0.25) * ONE_OVER_PI * rest * (R(1.0) + a)) / (squared * sqrt_w(squared));
}

FN realw hg_value_w(real g, real3w before, real3w after) {
  real3w apart = g < R(0.0) ? add3_w(after, before) : sub3_w(after, before);
  return hg_density_w(g, splat_w(R(0.5)) * dot3_w(apart, apart));
}

FN Turn_w hg_turn_w(real g, realw u) {
  real a = real_abs(g);
  realw one = splat_w(R(1.0)), two = splat_w(R(2.0)), left = one - u;
  realw inverse = one / fma_w(splat_w(R(2.0) * a), u, splat_w(R(1.0) - a));
  realw near = splat_w(R(1.0) - a) * inverse, far = splat_w(R(1.0) + a) * inverse;
  realw missing = two * left * fma_w(splat_w(a), u, one) * (near * near);
  realw beyond = two * u * fma_w(splat_w(-a), left, one) * (far * far);
  realw density = hg_density_w(g, missing);
  return g < R(0.0) ? turn_of_w(beyond, missing, density) : turn_of_w(missing, beyond, density);
}
