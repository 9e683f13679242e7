// SPDX-License-Identifier: MIT
// The same light from all directions.

FN LightRay_w constant_ray_w(const Scene* scene, GLOBAL const int* row, LightNumbers_w numbers, Real2_w way) {
  return far_ray_w(scene, constant_sample_w(scene, row, anywhere_w(), numbers), way);
}

FN realw constant_spread_w(const Scene* scene, GLOBAL const int* row, real3w way) {
  (void)row;
  (void)way;
  return far_spread_w(scene);
}
