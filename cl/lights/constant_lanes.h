// SPDX-License-Identifier: MIT
// The same radiance from everywhere, seen by rays that leave the scene; directions are drawn uniformly. Parameters:
// radiance r g b.

enum { constant_NUMBERS_w = NUMBERS_NONE_w };

FN LightSample_w constant_sample_w(const Scene* scene, const LightRows_w* at, real3w from, LightNumbers_w numbers) {
  (void)from;
  LightSample_w s = no_light_w();
  s.towards = square_to_sphere_w(numbers.u, numbers.v);
  s.t_max = splat_w(REAL_MAX);
  s.density = splat_w(R(0.25) * ONE_OVER_PI);
  s.radiance = splat3_w(load3(scene->shading + at->row[LIGHT_REALS]));
  return s;
}

FN FoundLight_w constant_background_w(const Scene* scene, GLOBAL const int* row, real3w towards) {
  (void)towards;
  FoundLight_w found;
  found.radiance = splat3_w(load3(scene->shading + row[LIGHT_REALS]));
  found.density = splat_w(R(0.25) * ONE_OVER_PI);
  return found;
}

FN realw constant_density_w(const Scene* scene, const LightRows_w* at, real3w from, real3w towards,
                            const Surfaces_w* s) {
  (void)from;
  (void)s;
  return constant_background_w(scene, at->row, towards).density;
}

#if HAS_LIGHT_PATHS
FN LightRay_w constant_ray_w(const Scene* scene, GLOBAL const int* row, LightNumbers_w numbers, Real2_w way) {
  LightRows_w at = rows_of_light_w(scene, row);
  return far_ray_w(scene, constant_sample_w(scene, &at, anywhere_w(), numbers), way);
}

FN realw constant_spread_w(const Scene* scene, GLOBAL const int* row, real3w way) {
  (void)row;
  (void)way;
  return far_spread_w(scene);
}
#endif
