// SPDX-License-Identifier: MIT
// Parallel light from one direction.

FN LightRay_w directional_ray_w(const Scene* scene, GLOBAL const int* row, LightNumbers_w numbers, Real2_w way) {
  return far_ray_w(scene, directional_sample_w(scene, row, anywhere_w(), numbers), way);
}

FN realw directional_spread_w(const Scene* scene, GLOBAL const int* row, real3w way) {
  (void)row;
  (void)way;
  return far_spread_w(scene);
}
