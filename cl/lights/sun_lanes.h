// SPDX-License-Identifier: MIT
// A disc in the sky, infinitely far away and equally bright all over: a cone of directions, seen by rays that leave the
// scene beside the background. The horizon cuts off what is below. Parameters: unit direction to its middle x y z; 1 -
// cos of half its opening; radiance r g b; the direction up x y z, 0 0 0 where there is no horizon.

enum { sun_NUMBERS_w = NUMBERS_NONE_w };

/// 1 - cos of the angle to its middle, from the chord: nothing cancels.
FN realw sun_less_w(GLOBAL const real* params, real3w towards) {
  real3w chord = sub3_w(unit3_w(towards), splat3_w(load3(params)));
  return splat_w(R(0.5)) * dot3_w(chord, chord);
}

/// What shines from that direction, which the cone has.
FN real3w sun_radiance_w(GLOBAL const real* params, real3w towards) {
  maskw is_down = lt_w(dot3_w(splat3_w(load3(params + 7)), towards), splat_w(R(0.0)));
  return sel3_w(is_down, no_light_found_w().radiance, splat3_w(load3(params + 4)));
}

FN LightSample_w sun_sample_w(const Scene* scene, const LightRows_w* at, real3w from, LightNumbers_w numbers) {
  GLOBAL const real* params = scene->shading + at->row[LIGHT_REALS];
  (void)from;
  LightSample_w s = no_light_w();
  Frame_w frame = frame_around_w(splat3_w(load3(params)));
  realw less = numbers.u * splat_w(params[3]), sine = sqrt_w(less * (splat_w(R(2.0)) - less));
  SinCos_w turned = sincos_turns_w(numbers.v);
  real3w way = vec3_w(sine * turned.cosine, sine * turned.sine, splat_w(R(1.0)) - less);
  s.towards = from_frame_w(&frame, way);
  s.t_max = splat_w(REAL_MAX);
  s.density = splat_w(R(0.5) * ONE_OVER_PI / params[3]);
  s.radiance = sun_radiance_w(params, s.towards);
  return s;
}

FN FoundLight_w sun_background_w(const Scene* scene, GLOBAL const int* row, real3w towards) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  maskw is_within = le_w(sun_less_w(params, towards), splat_w(params[3]));
  FoundLight_w found = no_light_found_w();
  found.radiance = sel3_w(is_within, sun_radiance_w(params, towards), found.radiance);
  found.density = sel_w(is_within, splat_w(R(0.5) * ONE_OVER_PI / params[3]), found.density);
  return found;
}

FN realw sun_density_w(const Scene* scene, const LightRows_w* at, real3w from, real3w towards, const Surfaces_w* s) {
  (void)from;
  (void)s;
  return sun_background_w(scene, at->row, towards).density;
}

#if HAS_LIGHT_PATHS
FN LightRay_w sun_ray_w(const Scene* scene, GLOBAL const int* row, LightNumbers_w numbers, Real2_w way) {
  LightRows_w at = rows_of_light_w(scene, row);
  return far_ray_w(scene, sun_sample_w(scene, &at, anywhere_w(), numbers), way);
}

FN realw sun_spread_w(const Scene* scene, GLOBAL const int* row, real3w way) {
  (void)row;
  (void)way;
  return far_spread_w(scene);
}
#endif
