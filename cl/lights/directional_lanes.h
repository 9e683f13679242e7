// SPDX-License-Identifier: MIT
// Light from infinitely far away. Parameters: unit direction of travel x y z, irradiance r g b (W/m^2).

enum { directional_NUMBERS_w = NUMBERS_NONE_w };

FN LightSample_w directional_sample_w(const Scene* scene, const LightRows_w* at, real3w from, LightNumbers_w numbers) {
  GLOBAL const real* params = scene->shading + at->row[LIGHT_REALS];
  (void)from;
  (void)numbers;
  LightSample_w s = no_light_w();
  s.towards = splat3_w(negate3(load3(params)));
  s.t_max = splat_w(REAL_MAX);
  s.radiance = splat3_w(load3(params + 3));
  s.is_delta = ~none_w();
  return s;
}

#if HAS_LIGHT_PATHS
FN LightRay_w directional_ray_w(const Scene* scene, GLOBAL const int* row, LightNumbers_w numbers, Real2_w way) {
  LightRows_w at = rows_of_light_w(scene, row);
  return far_ray_w(scene, directional_sample_w(scene, &at, anywhere_w(), numbers), way);
}

FN realw directional_spread_w(const Scene* scene, GLOBAL const int* row, real3w way) {
  (void)row;
  (void)way;
  return far_spread_w(scene);
}
#endif
