// SPDX-License-Identifier: MIT
// Light paths at their beginning: samples of a span, a path each. A path's random numbers belong to its place in one
// sequence of all paths of the picture, or of all that go into one sum, so that Sobol points spread evenly over the
// whole picture's paths: the sequence's number stands in for the pixel, and the place in it for the sample. One width;
// no guard.
#include "lights/leaving_lanes.h"

/// Samples that begin, a lane each.
typedef struct {
  maskw which;
  uintw pixels, numbers;  ///< Of the film, and of the pixel.
} NewPaths_w;

/// The state of sample `numbers` of pixel `pixels` of the film.
FN SampleState_w light_sample_begin_w(const Scene* scene, uintw pixels, uintw numbers) {
  PRIVATE const SplatFilm* film = scene->splats;
  uint sums = (uint)film->sums;
  uintw places = (numbers / sums) * ((uint)film->columns * (uint)film->rows) + pixels;
  return sequence_begin_w(scene, numbers & (sums - 1u), places, 1u);
}

/// Camera rays through pixels of the film, whose first one is (0, 0). offset, lens: camera/sample_place_lanes.h.
FN void film_rays_w(const Scene* scene, intw columns, intw rows, Real2_w offset, Real2_w lens, Rays_w* rays) {
  PRIVATE const SplatFilm* film = scene->splats;
  GLOBAL const int* index = scene->index;
  int height = (int)scene->shading[index[HEADER_SENSOR] + SENSOR_HEIGHT];
  camera_rays_w(scene->shading + index[HEADER_CAMERA], index[HEADER_WIDTH], height, columns + splat_int_w(film->x),
                film->y, offset.x, offset.y + real_of_int_w(rows), lens, rays);
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

/// Begins paths of the given samples in the lanes of `which`, whose radiance is then the flux; all others end. s: gets
/// the places on lights. choice: gets the lights.
FN LightRay_w light_paths_leave_w(const Scene* scene, Paths_w* path, maskw which, uintw pixels, uintw numbers,
                                  Surfaces_w* s, LightChoice_w* choice) {
  realw none = splat_w(R(0.0));
  maskw follows = none_w();
  LightRay_w ray = no_light_ray_w();
  path->sample = light_sample_begin_w(scene, pixels, numbers);
  path->alive = none_w();
  path->depth = splat_int_w(0);
  if (LIGHT_COUNT > 0 && lights_drawn_from(scene) > 0) {
    *choice = choose_light_w(scene, &path->sample, path->depth, vec3_w(none, none, none));
    Random2_w bits = vertex_pair_w(scene, &path->sample, path->depth, USE_WAY);
    Real2_w way;
    way.x = random_between_w(bits.x);
    way.y = random_between_w(bits.y);
    ray = light_ray_w(scene, which, choice->light, light_numbers_w(scene, &path->sample, path->depth), way);
    ray.flux = scale3_w(choice->rarity, ray.flux);
    follows = which & not_black_w(ray.flux);
  }
  *s = light_surface_w(&ray);
  Rays_w rays;
  rays_leaving_w(s, follows, ray.way, splat_w(REAL_MAX), &rays);
  maskw is_lamp = follows & ~ray.is_surface & ~ray.is_far;
  if (any_w(is_lamp)) rays_begin_later_w(&rays, is_lamp, lamp_clearance_w(ray.from, ray.from));
  paths_begin_w(scene, path, follows, &rays);
  path->radiance = sel3_w(follows, ray.flux, path->radiance);
  return ray;
}
