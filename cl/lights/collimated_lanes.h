// SPDX-License-Identifier: MIT
// A beam without width, which no point is joined with. Parameters: position x y z, unit direction x y z, power r g b
// (W).

enum { collimated_NUMBERS_w = NUMBERS_NONE_w };

FN LightSample_w collimated_sample_w(const Scene* scene, const LightRows_w* at, real3w from, LightNumbers_w numbers) {
  (void)scene;
  (void)at;
  (void)from;
  (void)numbers;
  LightSample_w s = no_light_w();
  s.is_delta = ~none_w();
  return s;
}

#if HAS_LIGHT_PATHS
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
#endif
