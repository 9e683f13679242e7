// SPDX-License-Identifier: MIT
// Light from a small cone of directions.

FN LightRay_w sun_ray_w(const Scene* scene, GLOBAL const int* row, LightNumbers_w numbers, Real2_w way) {
  return far_ray_w(scene, sun_sample_w(scene, row, anywhere_w(), numbers), way);
}

FN realw sun_spread_w(const Scene* scene, GLOBAL const int* row, real3w way) {
  (void)row;
  (void)way;
  return far_spread_w(scene);
}
