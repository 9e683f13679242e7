// SPDX-License-Identifier: MIT
// Point light: intensity / distance^2. Parameters: position x y z, intensity r g b (W/sr).

enum { point_NUMBERS_w = NUMBERS_NONE_w };

FN LightSample_w point_sample_w(const Scene* scene, GLOBAL const int* row, real3w from, LightNumbers_w numbers) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  (void)numbers;
  LightSample_w s = no_light_w();
  real3w lamp = splat3_w(load3(params));
  s.towards = sub3_w(lamp, from);
  realw length = length3_w(s.towards), inverse = splat_w(R(1.0)) / length;
  s.t_max = way_to_lamp_w(lamp, from, length);
  s.radiance = scale3_w(inverse, scale3_w(inverse, splat3_w(load3(params + 3))));
  s.is_delta = ~none_w();
  return s;
}
