// SPDX-License-Identifier: MIT
// Spot light: intensity * falloff / distance^2. The falloff is 1 up to the beam's half angle and falls linearly with
// the angle to 0 at the cutoff. Parameters: position x y z, unit axis x y z, intensity r g b (W/sr), cutoff in turns,
// one over the turns between beam and cutoff; of one with a texture, two vectors across the axis: the texture fills the
// square around the cone, u and v from 0 to 1 where their products with the direction, over the axis's, go from -1
// to 1.
#include "math/atan2_lanes.h"

enum { spot_NUMBERS_w = NUMBERS_NONE_w };

/// Of one without a texture.
enum { spot_REALS_w = 11 };

FN LightSample_w spot_sample_w(const Scene* scene, const LightRows_w* at, real3w from, LightNumbers_w numbers) {
  realw params[spot_REALS_w];
  light_reals_w(scene, at, spot_REALS_w, params);
  (void)numbers;
  LightSample_w s = no_light_w();
  real3w lamp = real3_at_w(params);
  s.towards = sub3_w(lamp, from);
  realw length = length3_w(s.towards), inverse = splat_w(R(1.0)) / length;
  s.t_max = way_to_lamp_w(lamp, from, length);
  real3w out = scale3_w(-inverse, s.towards), axis = real3_at_w(params + 3);
  realw turns = atan2_turns_w(length3_w(cross3_w(axis, out)), dot3_w(axis, out));
  realw falloff = (params[9] - turns) * params[10];
  falloff = max_w(min_w(falloff, splat_w(R(1.0))), splat_w(R(0.0)));
  s.radiance = scale3_w(falloff * inverse, scale3_w(inverse, real3_at_w(params + 6)));
  if (HAS_LIGHT_TEXTURE && at->row[LIGHT_TEXTURE] >= 0) {
    GLOBAL const real* across = scene->shading + at->row[LIGHT_REALS] + spot_REALS_w;
    realw zero = splat_w(R(0.0)), half_one = splat_w(R(0.5)), along = dot3_w(axis, out);
    realw half_over = half_one / sel_w(lt_w(zero, along), along, splat_w(R(1.0)));
    realw u = fma_w(dot3_w(splat3_w(load3(across)), out), half_over, half_one);
    realw v = fma_w(dot3_w(splat3_w(load3(across + 3)), out), half_over, half_one);
    TexturePlace_w place = texture_at_w(u, v);
    s.radiance = mul3_w(s.radiance, texture_value_w(scene, at->row[LIGHT_TEXTURE], &place));
  }
  s.is_delta = ~none_w();
  return s;
}

#if HAS_LIGHT_PATHS
/// 1 - cos of the cutoff, without cancellation.
FN realw spot_most_w(GLOBAL const real* params) {
  realw half_sine = sincos_turns_w(splat_w(R(0.5) * params[9])).sine;
  return splat_w(R(2.0)) * half_sine * half_sine;
}

/// Directions are drawn uniformly from the cone.
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
  LightRows_w at = rows_of_light_w(scene, row);
  LightSample_w s = spot_sample_w(scene, &at, point_in_way_w(ray.from, ray.way), numbers);
  ray.flux = scale3_w(splat_w(R(2.0) * PI) * most, intensity_of_w(&s));
  return ray;
}

FN realw spot_spread_w(const Scene* scene, GLOBAL const int* row, real3w way) {
  (void)way;
  return splat_w(R(0.5) / PI) / spot_most_w(scene->shading + row[LIGHT_REALS]);
}
#endif
