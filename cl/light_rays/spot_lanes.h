// SPDX-License-Identifier: MIT
// Spot light: directions are drawn uniformly from its cone.

/// 1 - cos of the cutoff, without cancellation.
FN realw spot_most_w(GLOBAL const real* params) {
  realw half_sine = sincos_turns_w(splat_w(R(0.5) * params[9])).sine;
  return splat_w(R(2.0)) * half_sine * half_sine;
}

FN LightRay_w spot_ray_w(const Scene* scene, GLOBAL const int* row, LightNumbers_w numbers, Real2_w way) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  realw one = splat_w(R(1.0)), two = splat_w(R(2.0));
  (void)way;
  LightRay_w ray = no_light_ray_w();
  ray.from = splat3_w(load3(params));
  realw most = spot_most_w(params), less = numbers.u * most, sine = sqrt_w(less * (two - less));
  SinCos_w turned = sincos_turns_w(numbers.v);
  Frame_w frame = frame_around_w(splat3_w(load3(params + 3)));
  ray.way = from_frame_w(&frame, vec3_w(sine * turned.cosine, sine * turned.sine, one - less));
  LightSample_w s = spot_sample_w(scene, row, point_in_way_w(ray.from, ray.way), numbers);
  ray.flux = scale3_w(splat_w(R(2.0) * PI) * most, intensity_of_w(&s));
  return ray;
}

FN realw spot_spread_w(const Scene* scene, GLOBAL const int* row, real3w way) {
  (void)way;
  return splat_w(R(0.5) / PI) / spot_most_w(scene->shading + row[LIGHT_REALS]);
}
