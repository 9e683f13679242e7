// SPDX-License-Identifier: MIT
// A beam without width, which no point is joined with. Parameters: position x y z, unit direction x y z, power r g b
// (W).

enum { collimated_NUMBERS_w = NUMBERS_NONE_w };

FN LightSample_w collimated_sample_w(const Scene* scene, GLOBAL const int* row, real3w from, LightNumbers_w numbers) {
  (void)scene;
  (void)row;
  (void)from;
  (void)numbers;
  LightSample_w s = no_light_w();
  s.is_delta = ~none_w();
  return s;
}
