// SPDX-License-Identifier: MIT
// A surface that shines along its normals alone, which no point is joined with. Parameters: those of an area
// (scene/layout.h, AREA_...), with the radiant exitance (W/m^2) in the place of the radiance.

enum { directionalarea_NUMBERS_w = NUMBERS_NONE_w };

FN LightSample_w directionalarea_sample_w(const Scene* scene, GLOBAL const int* row, real3w from,
                                          LightNumbers_w numbers) {
  (void)scene;
  (void)row;
  (void)from;
  (void)numbers;
  LightSample_w s = no_light_w();
  s.is_delta = ~none_w();
  return s;
}
