// SPDX-License-Identifier: MIT
// Every way alike. One width; no guard.

FN realw isotropic_value_w(real g, real3w before, real3w after) {
  (void)g;
  (void)before;
  (void)after;
  return splat_w(R(0.25) * ONE_OVER_PI);
}

FN Turn_w isotropic_turn_w(real g, realw u) {
  (void)g;
  realw one = splat_w(R(1.0)), two = splat_w(R(2.0));
  return turn_of_w(two * (one - u), two * u, splat_w(R(0.25) * ONE_OVER_PI));
}
