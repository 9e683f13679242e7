// SPDX-License-Identifier: MIT
// One work-item a pixel: PATH_LANES samples of it at a time, each a camera ray, then closest hit and integrator step in
// turns; the results go into the film. A launch covers a rectangle of the picture's pixels, columns x rows from
// (x_first, y_first) on, and samples [sample_first, sample_first + sample_count) of each of them. Values that are the
// same for all pixels are arguments where every pixel needs them: PoCL evaluates arguments once for a row of
// work-items, but reads buffers for each.
#include "math/vec3.h"
#include "lanes/lane_ops.h"
#include "accel/traverse.h"
#include "film/film.h"
#include "film/sub_sums.h"
#include "kernels/whole_loops.h"
#if PATH_LANES != LANES
#undef LANES
#define LANES PATH_LANES
#endif
#include "math/vec3_lanes.h"
#include "math/sampling_lanes.h"
#include "samplers/sampler_lanes.h"
#include "rays/departing_lanes.h"
#if LANES != 1
#if TIER_ROBUST
#include "shapes/exact/settle_lanes.h"
#endif
#include "accel/packet.h"
#endif
#include "hits/surfaces_lanes.h"
#include "camera/camera_lanes.h"
#include "integrators/paths_lanes.h"
#include "hits/find_lanes.h"
#include "integrators/integrator_lanes.h"
#include "film/first_albedo_lanes.h"
#if LANES != 1
#include "integrators/path_pool_lanes.h"
#endif

/// A pixel's samples: [next, end) have not begun yet.
typedef struct {
  int x, y, width, height, next, end;
} Pixel;

/// Begins samples of the pixel in lanes where no path is alive, as far as there are any.
FN void begin_paths_w(const Scene* scene, Paths_w* path, Pixel* pixel) {
  GLOBAL const real* shading = scene->shading;
  GLOBAL const int* index = scene->index;
  intw numbers = int_of_uint_w(path->sample.sample), is_begun = splat_int_w(0);
  for (uint idle = bits_w(~path->alive); idle != 0u && pixel->next < pixel->end; idle &= idle - 1u) {
    put_int_w(&numbers, first_bit(idle), pixel->next++);
    put_int_w(&is_begun, first_bit(idle), 1);
  }
  uint number = (uint)pixel->y * (uint)pixel->width + (uint)pixel->x;
  path->sample = sample_begin_w(scene, number, uint_of_int_w(numbers));
  realw dx = splat_w(R(0.0)), dy = dx;
  if (HAS_PIXEL_FILTER) {
    Random2_w bits = sample_pair_w(scene, &path->sample, USE_PIXEL);
    dx = filter_offset_w(shading + index[HEADER_FILTER], random_unit_w(bits.x));
    dy = filter_offset_w(shading + index[HEADER_FILTER], random_unit_w(bits.y));
  }
  Real2_w lens;
  lens.x = lens.y = splat_w(R(0.0));
  if (HAS_THIN_LENS) {
    Random2_w bits = sample_pair_w(scene, &path->sample, USE_LENS);
    lens = square_to_disk_w(random_between_w(bits.x), random_between_w(bits.y));
  }
  Rays_w rays;
  camera_rays_w(shading + index[HEADER_CAMERA], pixel->width, pixel->height, pixel->x, pixel->y, dx, dy, lens, &rays);
  paths_begin_w(path, nonzero_w(is_begun), &rays);
}

/// What the traversal looks for. The last digits of t are needed only where t is reported or the path goes on behind a
/// hit.
FN int wanted_w(const Scene* scene, const Paths_w* path, const FirstSample* first) {
  int is_exact = 0;
  if (HAS_AOV) is_exact = first->lane >= 0;
  if (HAS_EMISSION && hides_emitters(scene)) is_exact = any_w(path->alive & lt_int_w(path->depth, splat_int_w(1)));
  return is_exact ? FIND_NEAREST : FIND_NEAREST_APPROXIMATELY;
}

FN SubSums sub_sums_of(const Scene* scene) {
  SubSums sums;
  // One sum has the same mean as four.
  sums.count = HAS_ERROR_SUMS ? scene->index[HEADER_SUMS] : 1;
  sums.sequences = HAS_ERROR_SUMS ? scene->index[HEADER_SEQUENCES] : 1;
  sums.turn_bits = scene->index[HEADER_TURN_BITS];
  return sums;
}

/// One sample.
FN void add_sample(const Scene* scene, GLOBAL long* pixel_sums, SubSums sums, int sample, real3 light) {
  GLOBAL long* sum = pixel_sums + sub_sum_of(sums, sample) * (FILM_CHANNELS * FILM_SUM_WORDS);
  film_add_sample(scene, sum, light.x);
  film_add_sample(scene, sum + FILM_SUM_WORDS, light.y);
  film_add_sample(scene, sum + 2 * FILM_SUM_WORDS, light.z);
}

/// Adds `times` samples from `sample` on, all with this radiance. done: the word behind the counters (scene/layout.h).
FN void add_to_film(const Scene* scene, GLOBAL long* pixel_sums, SubSums sums, int sample, int times, real3 light,
                    GLOBAL uint* done) {
  // A black sample need not touch the film.
  if (light.x == R(0.0) && light.y == R(0.0) && light.z == R(0.0)) {
    if (HAS_LOOP_LIMIT) *done = (uint)(sample + times);
    return;
  }
  if (HAS_LOOP_LIMIT) {
    for (int i = sample; i < sample + times; ++i) {
      add_sample(scene, pixel_sums, sums, i, light);
      *done = (uint)(i + 1);  // Each by itself: the device may end this loop, too.
    }
    return;
  }
  if (times == 1) {
    add_sample(scene, pixel_sums, sums, sample, light);
    return;
  }
  for (int k = 0; k < sums.count; ++k) {
    int number = sub_sum_size(sums, k, sample + times) - sub_sum_size(sums, k, sample);
    GLOBAL long* sum = pixel_sums + k * (FILM_CHANNELS * FILM_SUM_WORDS);
    if (number == 0) continue;
    film_add_slowly(scene, sum, light.x, number);
    film_add_slowly(scene, sum + FILM_SUM_WORDS, light.y, number);
    film_add_slowly(scene, sum + 2 * FILM_SUM_WORDS, light.z, number);
  }
}

/// Where the samples of a pixel go.
typedef struct {
  GLOBAL long* sums;  ///< The pixel's in the film.
  SubSums sub_sums;
  GLOBAL uint* done;  ///< As in add_to_film.
  int times;          ///< Each sample counts so many times.
} PixelFilm;

/// One surface of each path that is alive; those that end there go into the film.
ONCE_FN void follow_paths_w(const Scene* scene, Paths_w* path, Branches_w* branches, FirstSample* first,
                            const PixelFilm* film) {
  uint before = bits_w(path->alive);
  Surfaces_w surfaces = find_surfaces_w(scene, path, wanted_w(scene, path, first), first);
  if (HAS_ALBEDO) store_albedo_w(scene, path, &surfaces, first);
  surface_step_w(scene, path, &surfaces, branches);
  if (HAS_AOV) first->lane = -1;
  for (uint ended = before & ~bits_w(path->alive); ended != 0u; ended &= ended - 1u) {
    if (HAS_LOOP_LIMIT && !loops_were_whole()) break;
    int i = first_bit(ended), sample = get_int_w((PRIVATE const intw*)&path->sample.sample, i);
    real3 light = vec3(get_w(&path->radiance.x, i), get_w(&path->radiance.y, i), get_w(&path->radiance.z, i));
    add_to_film(scene, film->sums, film->sub_sums, sample, film->times, light, film->done);
  }
}

FN PixelFilm pixel_film(const Scene* scene, GLOBAL long* sums, GLOBAL uint* done, int times) {
  PixelFilm film;
  film.sums = sums;
  film.sub_sums = sub_sums_of(scene);
  film.done = done;
  film.times = times;
  return film;
}

/// The pixel's samples, `times` each, in lanes that begin a new one when an eighth of them is idle. sums: the pixel's
/// in the film; done: as in add_to_film.
FN void follow_in_lanes_w(Scene scene, Pixel pixel, FirstSample first, GLOBAL long* sums, GLOBAL uint* done,
                          int times) {
  PixelFilm film = pixel_film(&scene, sums, done, times);
  Paths_w path;
  paths_none_w(&path);
  Branches_w branches;
  branches.count = splat_int_w(0);
  while (pixel.next < pixel.end) {
    begin_paths_w(&scene, &path, &pixel);
    int is_full;
    do {
      follow_paths_w(&scene, &path, &branches, &first, &film);
      // After the last sample idle lanes stay idle.
      is_full = pixel.next >= pixel.end || 8u * lanes_among(bits_w(~path.alive)) < LANES;
    } while (is_full && any_w(path.alive));
  }
}

ONCE_FN void follow_in_lanes_once_w(Scene scene, Pixel pixel, FirstSample first, GLOBAL long* sums, GLOBAL uint* done,
                                    int times) {
  follow_in_lanes_w(scene, pixel, first, sums, done, times);
}

#if LANES != 1
/// The same, in pools.
ONCE_FN void follow_in_pools_w(Scene scene, Pixel pixel, FirstSample first, GLOBAL long* sums, GLOBAL uint* done,
                               int times) {
  PixelFilm film = pixel_film(&scene, sums, done, times);
  PathPool_w pool;
  Paths_w path;
  Branches_w branches;
  paths_none_w(&path);
  branches.count = splat_int_w(0);
  pool_none_w(&pool);
  while (pixel.next < pixel.end || pool.count > 0) {
    int are_new = pool.count == 0, count = are_new ? min((int)POOL_w, pixel.end - pixel.next) : pool.count;
    for (int i = 0; i < count; i += LANES) {
      if (are_new) {
        path.alive = none_w();
        begin_paths_w(&scene, &path, &pixel);
      } else {
        pool_take_w(&pool, i, &path);
      }
      follow_paths_w(&scene, &path, &branches, &first, &film);
      pool_put_w(&pool, i, are_new, &path);
    }
    pool_turn_w(&pool);
  }
}
#endif

/// 1: the work of a pixel is a function that is called, so that it is compiled once. In short programs the call costs
/// more (docs/decisions/0017-once.md).
enum { IS_PROGRAM_LARGE = (LANES != 1) | (LIGHT_COUNT > 0) | (SCENE_LANED(IS_TRAVERSAL_LARGE) != 0) };

FN void render_pixel_w(Scene scene, Pixel pixel, FirstSample first, GLOBAL long* sums, GLOBAL uint* done, int times) {
#if LANES != 1
  // Branches wait in the lane of their sample.
  if (!HAS_BRANCHES) {
    follow_in_pools_w(scene, pixel, first, sums, done, times);
    return;
  }
#endif
  if (IS_PROGRAM_LARGE)
    follow_in_lanes_once_w(scene, pixel, first, sums, done, times);
  else
    follow_in_lanes_w(scene, pixel, first, sums, done, times);
}

KERNEL LANE_HINT_OF(SCENE_LANES) void render(GLOBAL const real* geometry, GLOBAL const real* shading,
                                             GLOBAL const int* index, GLOBAL long* film, GLOBAL real* aov_reals,
                                             GLOBAL int* aov_ints, GLOBAL uint* counters, int width, int height,
                                             int x_first, int y_first, int columns, int rows, int film_first,
                                             int film_columns, int sample_first, int sample_count) {
  int column = (int)get_global_id(0), row = (int)get_global_id(1);
  if (column >= columns || row >= rows) return;
  Scene scene;
  scene.geometry = geometry;
  scene.shading = shading;
  scene.index = index;
  scene.counters = counters;
  // film_first: index of the first of those pixels in the film buffer, whose rows are film_columns long.
  ulong slot = (ulong)film_first + (ulong)row * (ulong)film_columns + (ulong)column;

  // Where no random number is drawn, all samples of a pixel are equal.
  int do_differ = SAMPLER_COUNT > 0;
  if (HAS_PIXEL_FILTER || HAS_COUNT_RAYS) do_differ = 1;
  GLOBAL uint* done = counters + COUNTERS + slot;
  int next = sample_first, end = sample_first + sample_count;
  if (HAS_LOOP_LIMIT) next = min(max(next, (int)*done), end);  // Continues where an earlier launch stopped.
  Pixel pixel;
  pixel.x = x_first + column;
  pixel.y = y_first + row;
  pixel.width = width;
  pixel.height = height;
  pixel.next = next;
  pixel.end = do_differ ? end : min(next + 1, end);
  FirstSample first;
  first.reals = aov_reals + slot * AOV_REALS;
  first.ints = aov_ints + slot * AOV_INTS;
  first.lane = HAS_AOV && next == 0 ? 0 : -1;
  GLOBAL long* sums = film + slot * (ulong)(index[HEADER_SUMS] * FILM_CHANNELS * FILM_SUM_WORDS);
  int times = do_differ ? 1 : end - next;
  render_pixel_w(scene, pixel, first, sums, done, times);
  if (HAS_LOOP_LIMIT && (int)*done < end) {
    count_event(&scene, COUNT_CUT);
    if ((int)*done <= next) count_event(&scene, COUNT_STUCK);
  }
}
