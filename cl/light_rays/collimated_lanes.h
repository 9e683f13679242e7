// SPDX-License-Identifier: MIT
// A beam without width: all light leaves one place in one direction.

FN LightRay_w collimated_ray_w(const Scene* scene, GLOBAL const int* row, LightNumbers_w numbers, Real2_w way) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  (void)numbers;
  (void)way;
  LightRay_w ray = no_light_ray_w();
  ray.from = splat3_w(load3(params));
  ray.way = splat3_w(load3(params + 3));
  ray.flux = splat3_w(load3(params + 6));
  return ray;
}

FN realw collimated_spread_w(const Scene* scene, GLOBAL const int* row, real3w way) {
  (void)scene;
  (void)row;
  (void)way;
  return splat_w(REAL_MAX);
}
