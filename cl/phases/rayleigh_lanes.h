// SPDX-License-Identifier: MIT
// Scattering by what is much smaller than the wavelength: 3 / (16 pi) (1 + cos^2). Lord Rayleigh, "On the light from
// the sky, its polarization and colour", Philosophical Magazine 41, 1871. One width; no guard.

FN realw rayleigh_density_w(realw cosine) {
  realw scale = splat_w(R(0.1875) * ONE_OVER_PI);
  return fma_w(scale * cosine, cosine, scale);
}

FN realw rayleigh_value_w(real g, real3w before, real3w after) {
  (void)g;
  return rayleigh_density_w(dot3_w(before, after));
}

/// The distribution's inverse: cos^3 + 3 cos = 8 u - 4. Newton's method from the chord of its ends.
FN Turn_w rayleigh_turn_w(real g, realw u) {
  (void)g;
  realw one = splat_w(R(1.0)), three = splat_w(R(3.0));
  realw right = fma_w(splat_w(R(8.0)), u, splat_w(-R(4.0))), cosine = splat_w(R(0.25)) * right;
  for (int i = 0; i < (REAL_BITS == 64 ? 5 : 4); ++i) {
    realw square = cosine * cosine, over = fma_w(square + three, cosine, -right);
    cosine = cosine - over / fma_w(three, square, three);
  }
  cosine = max_w(min_w(cosine, one), -one);
  return turn_of_w(one - cosine, one + cosine, rayleigh_density_w(cosine));
}
