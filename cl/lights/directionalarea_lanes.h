// SPDX-License-Identifier: MIT
// A surface that shines along its normals alone, which no point is joined with. Parameters: those of an area
// (scene/layout.h, AREA_...), with the radiant exitance (W/m^2) in the place of the radiance.

enum { directionalarea_NUMBERS_w = NUMBERS_NONE_w };

FN LightSample_w directionalarea_sample_w(const Scene* scene, const LightRows_w* at, real3w from,
                                          LightNumbers_w numbers) {
  (void)scene;
  (void)at;
  (void)from;
  (void)numbers;
  LightSample_w s = no_light_w();
  s.is_delta = ~none_w();
  return s;
}

#if HAS_LIGHT_PATHS
/// What flows through the surface is its exitance, as Mitsuba 3 has it under the name of radiance.
FN LightRay_w directionalarea_ray_w(const Scene* scene, GLOBAL const int* row, LightNumbers_w numbers, Real2_w way) {
  (void)way;
  LightRay_w ray = area_place_w(scene, row, numbers);
  ray.way = ray.normal;
  ray.flux = scale3_w(splat_w(R(1.0) / scene->shading[row[LIGHT_REALS] + AREA_INVERSE]), ray.flux);
  return ray;
}

FN realw directionalarea_spread_w(const Scene* scene, GLOBAL const int* row, real3w way) {
  (void)scene;
  (void)row;
  (void)way;
  return splat_w(REAL_MAX);
}
#endif
