// SPDX-License-Identifier: MIT
// One work-item a pixel: PATH_LANES samples of it at a time, each a camera ray, then closest hit and integrator step in
// turns; the results go into the film. Where samples are too few for that, a work-item takes a span of span_columns
// pixels. A launch covers a rectangle of the picture's pixels, columns x rows from (x_first, y_first) on, and samples
// [sample_first, sample_first + sample_count) of each of them. Values that are the
// same for all pixels are arguments where every pixel needs them: PoCL evaluates arguments once for a row of
// work-items, but reads buffers for each.
#include "math/vec3.h"
#include "lanes/lane_ops.h"
#include "accel/traverse.h"
#include "film/span_film.h"
#include "kernels/path_parts.h"
#include "film/first_albedo_lanes.h"
#if HAS_MEDIA
#include "media/first_boundary_lanes.h"
#endif
#if LANES != 1
#include "integrators/path_pool_lanes.h"
#include "film/pixel_samples_lanes.h"
#endif

/// What the traversal looks for. The last digits of t are needed only where t is reported or the path goes on behind a
/// hit.
FN int wanted_w(const Scene* scene, const Paths_w* path, const FirstSamples* first) {
  int is_exact = 0;
  if (HAS_AOV) is_exact = first->lanes != 0u;
  if (HAS_EMISSION && hides_emitters(scene)) is_exact = any_w(path->alive & lt_int_w(path->depth, splat_int_w(1)));
#if HAS_MEDIA
  // Boundaries of media are before a surface or behind it.
  if (media_table(scene)[MEDIA_BOUNDARIES] != 0 || any_w(path->alive & is_within_w(path->medium))) is_exact = 1;
#endif
  return is_exact ? FIND_NEAREST : FIND_NEAREST_APPROXIMATELY;
}

/// One surface of each path that is alive.
ONCE_FN void follow_paths_w(const Scene* scene, Paths_w* path, Branches_w* branches, FirstSamples* first) {
#if HAS_MEDIA
  Outlook_w outlook = look_ahead_w(scene, path, HAS_AOV ? are_first_w(first) : none_w());
  Surfaces_w surfaces = meet_surfaces_w(scene, path, wanted_w(scene, path, first), first);
#else
  Surfaces_w surfaces = find_surfaces_w(scene, path, wanted_w(scene, path, first), first);
#endif
  if (HAS_ALBEDO) store_albedo_w(scene, path, &surfaces, first);
#if HAS_MEDIA
  if (HAS_AOV && first->lanes != 0u) store_boundaries_w(scene, path, &surfaces, first);
  media_travel_w(scene, path, &outlook, &surfaces);
#endif
  surface_step_w(scene, path, &surfaces, branches);
  if (HAS_AOV) first->lanes = 0u;
}

/// Adds the paths among `before` that are no longer alive to the film.
FN void add_ended_w(const Scene* scene, const Paths_w* path, uint before, const SpanFilm* film) {
  for (uint ended = before & ~bits_w(path->alive); ended != 0u; ended &= ended - 1u) {
    if (HAS_LOOP_LIMIT && !loops_were_whole()) break;
    int i = first_bit(ended);
    int pixel = get_int_w((PRIVATE const intw*)&path->sample.pixel, i);
    int sample = get_int_w((PRIVATE const intw*)&path->sample.sample, i);
    real3 light = vec3(get_w(&path->radiance.x, i), get_w(&path->radiance.y, i), get_w(&path->radiance.z, i));
    add_to_film(scene, film, pixel, sample, light);
  }
}

/// The span's samples in lanes that begin a new one when an eighth of them is idle. One loop over surfaces, not one
/// over samples with one over surfaces within: work-items that a device runs in lockstep would wait there for the
/// longest path among them.
FN void follow_in_lanes_w(Scene scene, Span span, FirstSamples first, SpanFilm film) {
  Paths_w path;
  paths_none_w(&path);
  Branches_w branches;
  branches_none_w(&branches);
  while (span_left(&span) > 0 || any_w(path.alive)) {
    if (span_left(&span) > 0 && 8u * lanes_among(bits_w(~path.alive)) >= LANES) {
      maskw are_first = begin_paths_w(&scene, &path, &span);
      if (HAS_AOV) first.lanes = bits_w(are_first);
    }
    uint before = bits_w(path.alive);
    follow_paths_w(&scene, &path, &branches, &first);
    add_ended_w(&scene, &path, before, &film);
  }
}

ONCE_FN void follow_in_lanes_once_w(Scene scene, Span span, FirstSamples first, SpanFilm film) {
  follow_in_lanes_w(scene, span, first, film);
}

#if LANES != 1
/// Adds the `count` paths that began at `begun`, in the order of their places, to the film.
FN void add_pool_w(const Scene* scene, const PathPool_w* pool, const Span* begun, int count, const SpanFilm* film) {
  PixelSamples_w samples;
  samples.first = begun->next;
  samples.count = count;
  for (int g = 0; g < groups_of_samples_w(&samples); ++g) {
    real3w light = pool_light_w(pool, g * LANES);
    samples.light[0][g] = light.x;
    samples.light[1][g] = light.y;
    samples.light[2][g] = light.z;
  }
  int column = begun->column;
  if (!HAS_MOMENT && film->times == 1 && count >= LANES && count <= begun->end - begun->next) {
    add_samples_w(scene, &samples, film->sub_sums, film->sums + (ulong)column * (ulong)film->pixel_words);
    return;
  }
  int sample = begun->next;
  for (int i = 0; i < count; ++i) {
    add_to_film(scene, film, film->first_pixel + column, sample, light_of_sample_w(&samples, i));
    if (++sample < begun->end) continue;
    sample = begun->first;
    ++column;
  }
}

/// As follow_in_lanes_w, in pools.
ONCE_FN void follow_in_pools_w(Scene scene, Span span, FirstSamples first, SpanFilm film) {
  PathPool_w pool;
  Span begun = span;
  Paths_w path;
  Branches_w branches;
  paths_none_w(&path);
  branches_none_w(&branches);
  pool_none_w(&pool);
  while (span_left(&span) > 0 || pool.count > 0) {
    int are_new = pool.count == 0, count = are_new ? min((int)POOL_PATHS, span_left(&span)) : pool.count;
    if (are_new) begun = span;
    for (int i = 0; i < count; i += LANES) {
      if (are_new) {
        path.alive = none_w();
        maskw are_first = begin_paths_w(&scene, &path, &span);
        if (HAS_AOV) first.lanes = bits_w(are_first);
      } else {
        pool_take_w(&pool, i, &path);
      }
      follow_paths_w(&scene, &path, &branches, &first);
      pool_put_w(&pool, i, are_new, count, &path);
    }
    pool_turn_w(&pool);
    if (pool.count == 0) add_pool_w(&scene, &pool, &begun, span_left(&begun) - span_left(&span), &film);
  }
}
#endif

/// 1: the work of a span is a function that is called, so that it is compiled once. In short programs the call costs
/// more (docs/decisions/0017-once.md).
enum { IS_PROGRAM_LARGE = (LANES != 1) | (LIGHT_COUNT > 0) | (SCENE_LANED(IS_TRAVERSAL_LARGE) != 0) };

FN void render_span_w(Scene scene, Span span, FirstSamples first, SpanFilm film) {
#if LANES != 1
  // Branches wait in the lane of their sample.
  if (!HAS_BRANCHES) {
    follow_in_pools_w(scene, span, first, film);
    return;
  }
#endif
  if (IS_PROGRAM_LARGE)
    follow_in_lanes_once_w(scene, span, first, film);
  else
    follow_in_lanes_w(scene, span, first, film);
}

KERNEL LANE_HINT_OF(SCENE_LANES) void render(GLOBAL const real* geometry, GLOBAL const real* shading,
                                             GLOBAL const int* index, GLOBAL long* film, GLOBAL real* aov_reals,
                                             GLOBAL int* aov_ints, GLOBAL uint* counters, int width, int height,
                                             int x_first, int y_first, int columns, int rows, int span_columns,
                                             int film_first, int film_columns, int sample_first, int sample_count) {
  int column = (int)get_global_id(0) * span_columns, row = (int)get_global_id(1);
  if (column >= columns || row >= rows) return;
  Scene scene = scene_of(geometry, shading, index, counters);
  // film_first: index of the first of those pixels in the film buffer, whose rows are film_columns long.
  ulong slot = (ulong)film_first + (ulong)row * (ulong)film_columns + (ulong)column;

  // Where no random number is drawn, all samples of a pixel are equal.
  int do_differ = SAMPLER_COUNT > 0;
  if (HAS_PIXEL_FILTER || HAS_COUNT_RAYS) do_differ = 1;
  GLOBAL uint* done = counters + COUNTERS + slot;
  int next = sample_first, end = sample_first + sample_count;
  if (HAS_LOOP_LIMIT) next = min(max(next, (int)*done), end);  // Continues where an earlier launch stopped.
  Span span;
  span.x = x_first + column;
  span.y = y_first + row;
  span.columns = LANES == 1 ? 1 : min(span_columns, columns - column);
  span.width = width;
  span.height = height;
  span.first = span.next = next;
  span.end = do_differ ? end : min(next + 1, end);
  span.column = 0;
  FirstSamples first;
  first.reals = aov_reals + slot * AOV_REALS;
  first.ints = aov_ints + slot * AOV_INTS;
  first.first_pixel = span_pixel(&span);
  first.lanes = 0u;
  SpanFilm to;
  to.pixel_words = (index[HEADER_SUMS] + HAS_MOMENT) * FILM_CHANNELS * FILM_SUM_WORDS;
  to.sums = film + slot * (ulong)to.pixel_words;
  to.done = done;
  to.sub_sums = sub_sums_of(&scene);
  to.first_pixel = span_pixel(&span);
  to.times = do_differ ? 1 : end - next;
  render_span_w(scene, span, first, to);
  if (HAS_LOOP_LIMIT && (int)*done < end) {
    count_event(&scene, COUNT_CUT);
    if ((int)*done <= next) count_event(&scene, COUNT_STUCK);
  }
}
