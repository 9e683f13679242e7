// SPDX-License-Identifier: MIT
// One work-item a pixel: camera ray, closest hit, a step of the integrator, film. A launch covers a rectangle of the
// picture's pixels, columns x rows from (x_first, y_first) on, and samples [sample_first, sample_first + sample_count)
// of each of them. What is the same for all pixels comes as an argument where every pixel needs it: PoCL computes with
// arguments once for a row of work-items, while what is read from a buffer is read again.
#include "math/vec3.h"
#include "math/rng.h"
#include "lanes/lane_ops.h"
#include "accel/traverse.h"
#include "shapes/shape.h"
#include "core/camera.h"
#include "core/film.h"
#include "samplers/sampler.h"
#include "integrators/integrator.h"

FN void store_first_sample(GLOBAL real* reals, GLOBAL int* ints, const Ray* ray, int hit, real t, const Surface* s) {
  for (int i = 0; i < AOV_REALS; ++i) reals[i] = R(0.0);
  ints[AOV_SHAPE] = -1;
  ints[AOV_PRIMITIVE] = -1;
  GLOBAL real* traced = reals + AOV_RAY;
  traced[RAY_O] = ray->o.x;
  traced[RAY_O + 1] = ray->o.y;
  traced[RAY_O + 2] = ray->o.z;
  traced[RAY_D] = ray->d.x;
  traced[RAY_D + 1] = ray->d.y;
  traced[RAY_D + 2] = ray->d.z;
  traced[RAY_T_MIN] = ray->t_min;
  traced[RAY_T_MAX] = ray->t_max;
  if (!hit) return;
  reals[AOV_T] = t;
  reals[AOV_DEPTH] = length3(sub3(s->position, ray->o));
  reals[AOV_NORMAL] = s->shading.x;
  reals[AOV_NORMAL + 1] = s->shading.y;
  reals[AOV_NORMAL + 2] = s->shading.z;
  reals[AOV_POSITION] = s->position.x;
  reals[AOV_POSITION + 1] = s->position.y;
  reals[AOV_POSITION + 2] = s->position.z;
  reals[AOV_UV] = s->tex_u;
  reals[AOV_UV + 1] = s->tex_v;
  ints[AOV_SHAPE] = s->shape;
  ints[AOV_PRIMITIVE] = s->primitive;
}

KERNEL LANE_HINT void render(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index,
                             GLOBAL long* film, GLOBAL real* aov_reals, GLOBAL int* aov_ints, GLOBAL uint* counters,
                             int width, int height, int x_first, int y_first, int columns, int rows, int film_first,
                             int film_columns, int film_sums, int sample_first, int sample_count) {
  int column = (int)get_global_id(0), row = (int)get_global_id(1);
  if (column >= columns || row >= rows) return;
  Scene scene;
  scene.geometry = geometry;
  scene.shading = shading;
  scene.index = index;
  scene.counters = counters;
  int x = x_first + column, y = y_first + row;
  uint pixel = (uint)y * (uint)width + (uint)x;
  // film_first: the first of those pixels in the film buffer, whose rows are film_columns long; film_sums: 1 or
  // FILM_SUBSUMS for each of them.
  ulong slot = (ulong)film_first + (ulong)row * (ulong)film_columns + (ulong)column;
  real film_scale = shading[index[HEADER_FILM_SCALE]];
  GLOBAL long* pixel_sums = film + slot * (ulong)(film_sums * FILM_CHANNELS);

  // Where nothing is drawn all samples of a pixel are the same one.
  int do_differ = SAMPLER_COUNT > 0;
  if (HAS_PIXEL_FILTER || HAS_COUNT_RAYS) do_differ = 1;
  int sample_end = sample_first + (do_differ ? sample_count : 1), times = do_differ ? 1 : sample_count;
  for (int sample = sample_first; sample < sample_end; ++sample) {
    real dx = R(0.0), dy = R(0.0);
    SampleState state = sample_begin(&scene, pixel, (uint)sample);
    if (HAS_PIXEL_FILTER) {
      Random2 bits = sample_pair(&scene, &state, SET_PIXEL);
      dx = filter_offset(shading + index[HEADER_FILTER], random_unit(bits.x));
      dy = filter_offset(shading + index[HEADER_FILTER], random_unit(bits.y));
    }
    Path path = path_begin(camera_ray(shading + index[HEADER_CAMERA], width, height, x, y, dx, dy), state);
    int more, is_first = 1;
    do {
      // Only who reports t or goes on behind a hit has need of its last digits.
      int is_exact = 0;
      if (HAS_AOV && sample == 0) is_exact = is_first;
      if (HAS_EMISSION && hides_emitters(&scene)) is_exact = is_first;
      Nearest nearest = LANED(closest_hit)(&scene, &path.ray, is_exact ? FIND_NEAREST : FIND_NEAREST_ROUGHLY);
      int hit = nearest.kind >= 0;
      Surface surface = surface_none();
      if (hit) surface = surface_at(&scene, &path.ray, &nearest, LANES);
      if (HAS_AOV && sample == 0 && is_first)
        store_first_sample(aov_reals + slot * AOV_REALS, aov_ints + slot * AOV_INTS, &path.ray, hit, nearest.t,
                           &surface);
      more = LANED(surface_step)(&scene, &path, hit, &surface, nearest.id, nearest.t);
      is_first = 0;
    } while (more);
    // The background's share of a picture need not touch the film.
    if (path.radiance.x == R(0.0) && path.radiance.y == R(0.0) && path.radiance.z == R(0.0)) continue;
    for (int i = sample; i < sample + times; ++i) {
      // One sum holds what four do: integers, so the mean is the same.
      GLOBAL long* sums = pixel_sums + (HAS_ERROR_SUMS ? i & (film_sums - 1) : 0) * FILM_CHANNELS;
      sums[0] += film_units(&scene, path.radiance.x, film_scale);
      sums[1] += film_units(&scene, path.radiance.y, film_scale);
      sums[2] += film_units(&scene, path.radiance.z, film_scale);
    }
  }
}
