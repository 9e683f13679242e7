// SPDX-License-Identifier: MIT
// Light from all around, as an image has it.

FN LightRay_w envmap_ray_w(const Scene* scene, GLOBAL const int* row, LightNumbers_w numbers, Real2_w way) {
  return far_ray_w(scene, envmap_sample_w(scene, row, anywhere_w(), numbers), way);
}

FN realw envmap_spread_w(const Scene* scene, GLOBAL const int* row, real3w way) {
  (void)row;
  (void)way;
  return far_spread_w(scene);
}
