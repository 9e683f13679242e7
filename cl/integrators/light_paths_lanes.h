// SPDX-License-Identifier: MIT
// Light paths at their beginning: samples of a span, a path each. A path's random numbers belong to its place in one
// sequence of all paths of the picture, or of all that go into one sum, so that Sobol points spread evenly over the
// whole picture's paths: the sequence's number stands in for the pixel, and the place in it for the sample. One width;
// no guard.
#include "light_rays/light_ray_lanes.h"

/// The state of sample `numbers` of pixel `pixels` of the film.
FN SampleState_w light_sample_begin_w(const Scene* scene, uintw pixels, uintw numbers) {
  PRIVATE const SplatFilm* film = scene->splats;
  uint sums = (uint)film->sums;
  SampleState_w state;
  state.pixel = numbers & (sums - 1u);
  state.sample = (numbers / sums) * ((uint)film->columns * (uint)film->rows) + pixels;
  state.seed = (uint)scene->index[HEADER_SEED];
  state.sequences = 1u;
  state.reversed = state.key = splat_uint_w(0u);
  switch (scene->index[HEADER_SAMPLER]) {
#define SAMPLER(name)       \
  case SAMPLER_##name:      \
    name##_begin_w(&state); \
    break;
#include "samplers/samplers.def"
#undef SAMPLER
    default:
      break;
  }
  return state;
}

/// What the camera sees behind the scene is seen along a ray through a pixel that the path's numbers draw.
FN void show_background_w(const Scene* scene, const Paths_w* path, maskw which) {
  PRIVATE const SplatFilm* film = scene->splats;
  GLOBAL const int* index = scene->index;
  Random2_w at = sample_pair_w(scene, &path->sample, USE_SEEN), within = sample_pair_w(scene, &path->sample, USE_PIXEL);
  intw columns = int_of_uint_w(high_product_w(at.x, splat_uint_w((uint)film->columns)));
  intw rows = int_of_uint_w(high_product_w(at.y, splat_uint_w((uint)film->rows)));
  realw dx = filter_offset_w(scene->shading + index[HEADER_FILTER], random_unit_w(within.x));
  realw dy = filter_offset_w(scene->shading + index[HEADER_FILTER], random_unit_w(within.y));
  Real2_w lens;
  lens.x = lens.y = splat_w(R(0.0));
  if (HAS_THIN_LENS) {
    Random2_w bits = sample_pair_w(scene, &path->sample, USE_LENS);
    lens = square_to_disk_w(random_between_w(bits.x), random_between_w(bits.y));
  }
  Rays_w rays;
  dy = dy + real_of_int_w(rows);
  int height = (int)scene->shading[index[HEADER_SENSOR] + SENSOR_HEIGHT];
  camera_rays_w(scene->shading + index[HEADER_CAMERA], index[HEADER_WIDTH], height, columns + splat_int_w(film->x),
                film->y, dx, dy, lens, &rays);
  real3w d = real3_at_w(rays.planes + RAY_PLANE_D), light = far_radiance_w(scene, HEADER_BACKGROUND, d);
  if (HAS_SUN) light = add3_w(light, far_radiance_w(scene, HEADER_SUN, d));
  which = which & lt_w(splat_w(R(0.0)), max3_w(light));
  if (!any_w(which)) return;
  if (is_seen_through_w(scene)) {
    Paths_w ahead = *path;
    ahead.alive = which;
    ahead.rays = rays;
    light = scale3_w(passed_share_w(scene, &ahead), light);
    which = which & lt_w(splat_w(R(0.0)), max3_w(light));
  } else {
    which = which & ~meets_any_w(scene, &rays, which);
  }
  for (uint lanes = bits_w(which); lanes != 0u; lanes &= lanes - 1u) {
    int i = first_bit(lanes), sum = get_int_w((PRIVATE const intw*)&path->sample.pixel, i);
    splat_pixel(scene, get_int_w(&columns, i), get_int_w(&rows, i), sum, SPLAT_OF_BACKGROUND_w, get3_w(&light, i));
  }
}

/// A place on a light as a surface that rays leave.
FN Surfaces_w light_surface_w(const LightRay_w* ray) {
  Surfaces_w s = surfaces_none_w();
  s.position = s.point = ray->from;
  s.normal = s.shading = ray->normal;
  s.bound = ray->bound;
  s.id = splat_int_w(-1);
  return s;
}

/// m ? a : b.
FN uintw light_number_w(maskw m, uintw a, uintw b) {
  return uint_of_int_w(sel_int_w(m, int_of_uint_w(a), int_of_uint_w(b)));
}

/// Begins paths of the given samples in the lanes of `which`.
FN void light_paths_begin_w(const Scene* scene, Paths_w* path, maskw which, uintw pixels, uintw numbers) {
  SampleState_w state = light_sample_begin_w(scene, pixels, numbers);
  intw zero = splat_int_w(0), one = splat_int_w(1);
  realw none = splat_w(R(0.0));
  Paths_w begun = *path;
  begun.sample = state;
  begun.depth = zero;
  int is_shown = scene->index[HEADER_MAX_DEPTH] > 0 && !hides_emitters(scene);
  int is_open = LIGHT_COUNT > 0 && (scene->index[HEADER_BACKGROUND] >= 0 || scene->index[HEADER_SUN] >= 0);
  if (is_shown && is_open) show_background_w(scene, &begun, which);
  maskw follows = none_w();
  LightRay_w ray = no_light_ray_w();
  if (LIGHT_COUNT > 0 && lights_drawn_from(scene) > 0) {
    LightChoice_w choice = choose_light_w(scene, &state, zero, vec3_w(none, none, none));
    Random2_w bits = vertex_pair_w(scene, &state, zero, USE_WAY);
    Real2_w way;
    way.x = random_between_w(bits.x);
    way.y = random_between_w(bits.y);
    ray = light_ray_w(scene, which, choice.light, light_numbers_w(scene, &state, zero), way);
    ray.flux = scale3_w(choice.rarity, ray.flux);
    follows = which & lt_w(none, max3_w(ray.flux));
  }
  Surfaces_w s = light_surface_w(&ray);
  if (is_shown && any_w(follows & ray.is_surface)) {
    SensorWay_w seen = way_to_sensor_w(scene, &begun, follows & ray.is_surface, ray.from);
    realw cosine = dot3_w(ray.normal, unit3_w(seen.towards));
    maskw is_front = seen.which & lt_w(none, cosine);
    send_to_sensor_w(scene, &begun, &s, is_front, &seen, scale3_w(splat_w(ONE_OVER_PI) * cosine, ray.flux));
  }
  Rays_w rays;
  rays_leaving_w(&s, follows, ray.way, splat_w(REAL_MAX), &rays);
  path->sample.seed = state.seed;
  path->sample.sequences = state.sequences;
  path->sample.pixel = light_number_w(which, state.pixel, path->sample.pixel);
  path->sample.sample = light_number_w(which, state.sample, path->sample.sample);
  path->sample.reversed = light_number_w(which, state.reversed, path->sample.reversed);
  path->sample.key = light_number_w(which, state.key, path->sample.key);
  paths_begin_w(scene, path, follows, &rays);
  path->radiance = sel3_w(follows, ray.flux, path->radiance);
  path->depth = sel_int_w(follows, one, path->depth);
}
