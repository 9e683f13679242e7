// SPDX-License-Identifier: MIT
// Point light: intensity / distance^2. Parameters: position x y z, intensity r g b (W/sr).

enum { point_NUMBERS_w = NUMBERS_NONE_w };

enum { point_REALS_w = 6 };

FN LightSample_w point_sample_w(const Scene* scene, const LightRows_w* at, real3w from, LightNumbers_w numbers) {
  realw params[point_REALS_w];
  light_reals_w(scene, at, point_REALS_w, params);
  (void)numbers;
  LightSample_w s = no_light_w();
  real3w lamp = real3_at_w(params);
  s.towards = sub3_w(lamp, from);
  realw length = length3_w(s.towards), inverse = splat_w(R(1.0)) / length;
  s.t_max = way_to_lamp_w(lamp, from, length);
  s.radiance = scale3_w(inverse, scale3_w(inverse, real3_at_w(params + 3)));
  s.is_delta = ~none_w();
  return s;
}

#if HAS_LIGHT_PATHS
FN LightRay_w point_ray_w(const Scene* scene, GLOBAL const int* row, LightNumbers_w numbers, Real2_w way) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  (void)way;
  LightRay_w ray = no_light_ray_w();
  ray.from = splat3_w(load3(params));
  ray.way = square_to_sphere_w(numbers.u, numbers.v);
  ray.flux = scale3_w(splat_w(R(4.0) * PI), splat3_w(load3(params + 3)));
  return ray;
}

FN realw point_spread_w(const Scene* scene, GLOBAL const int* row, real3w way) {
  (void)scene;
  (void)row;
  (void)way;
  return splat_w(R(0.25) / PI);
}
#endif
