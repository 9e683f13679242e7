// SPDX-License-Identifier: MIT
// One work-item a pixel: PATH_LANES samples of it at a time, each a camera ray, then closest hit and integrator step in
// turns; the results go into the film. Where samples are too few for that, a work-item takes a span of span_columns
// pixels. A launch covers a rectangle of the picture's pixels, columns x rows from (x_first, y_first) on, and samples
// [sample_first, sample_first + sample_count) of each of them. Values that are the same for all pixels are arguments
// where every pixel needs them: PoCL evaluates arguments once for a row of work-items, but reads buffers for each.
// Samples that count in several pixels wait for the kernel of another program (kernels/share_samples.cl).
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
    if (HAS_SHARED_SAMPLES)
      keep_sample(scene, film, pixel, sample, light);
    else
      add_to_film(scene, film, pixel, sample, light);
  }
}

#if LANES != 1
/// As keep_sample: samples that follow each other in the span do so in the ring.
FN void keep_samples_w(const Scene* scene, const WaitingSamples_w* samples, GLOBAL real* at, int plane) {
  for (int g = 0; g < groups_of_samples_w(samples); ++g)
    for (int c = 0; c < FILM_CHANNELS; ++c) {
      int count = min((int)LANES, samples->count - g * LANES);
      GLOBAL real* to = at + (RING_R + c) * plane + g * LANES;
      realw light = samples->light[c][g];
      maskw is_held = finite_w(light) & le_w(abs_w(light), splat_w(FILM_LARGEST));
      if (count == LANES && bits_w(~is_held) == 0u) {
        write_w(light, to);
        continue;
      }
      for (int lane = 0; lane < count; ++lane) to[lane] = film_value(scene, get_w(&light, lane), 1);
    }
}
#endif

/// Begins samples where no path is alive, and keeps where in their pixels they lie.
FN void begin_samples_w(const Scene* scene, Paths_w* path, Span* span, FirstSamples* first, const SpanFilm* film) {
  BegunSamples_w begun = begin_paths_w(scene, path, span);
  if (HAS_AOV) {
    intw column = int_of_uint_w(path->sample.pixel) - splat_int_w(first->first_pixel);
    maskw is_in = ~lt_int_w(column, splat_int_w(first->from)) & lt_int_w(column, splat_int_w(first->end));
    first->lanes = bits_w(begun.are_first & is_in);
  }
  if (!HAS_SHARED_SAMPLES) return;
#if LANES != 1
  // A pool's follow each other.
  if (bits_w(begun.which) == bits_w(~none_w())) {
    GLOBAL real* at = place_in_ring(film, get_int_w((PRIVATE const intw*)&path->sample.pixel, 0),
                                    get_int_w((PRIVATE const intw*)&path->sample.sample, 0));
    write_w(begun.offset.x, at + RING_X * ring_plane(&film->ring));
    write_w(begun.offset.y, at + RING_Y * ring_plane(&film->ring));
    return;
  }
#endif
  for (uint lanes = bits_w(begun.which); lanes != 0u; lanes &= lanes - 1u) {
    int i = first_bit(lanes), step = ring_plane(&film->ring);
    GLOBAL real* at = place_in_ring(film, get_int_w((PRIVATE const intw*)&path->sample.pixel, i),
                                    get_int_w((PRIVATE const intw*)&path->sample.sample, i));
    at[RING_X * step] = get_w(&begun.offset.x, i);
    at[RING_Y * step] = get_w(&begun.offset.y, i);
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
    if (span_left(&span) > 0 && 8u * lanes_among(bits_w(~path.alive)) >= LANES)
      begin_samples_w(&scene, &path, &span, &first, &film);
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
  WaitingSamples_w samples;
  samples.count = count;
  for (int g = 0; g < groups_of_samples_w(&samples); ++g) put_channels_w(pool_light_w(pool, g * LANES), g, &samples);
  int column = begun->column;
  if (HAS_SHARED_SAMPLES) {
    keep_samples_w(scene, &samples, place_in_ring(film, film->first_pixel + column, begun->next),
                   ring_plane(&film->ring));
    return;
  }
  for (int place = 0, sample = begun->next; place < count; ++column, sample = begun->first) {
    PixelRun run = run_from_w(&samples, place, sample, begun->end);
    if (!HAS_MOMENT && film->times == 1 && run.count >= LEAST_RUN_w)
      add_run_w(scene, &samples, &run, film->sub_sums, film->sums + (ulong)column * (ulong)film->pixel_words);
    else
      for (int i = 0; i < run.count; ++i)
        add_to_film(scene, film, film->first_pixel + column, sample + i, light_of_sample_w(&samples, place + i));
    place += run.count;
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
        begin_samples_w(&scene, &path, &span, &first, &film);
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

#if HAS_SHARED_SAMPLES
#define FILM_OR_RING GLOBAL real* ring
#else
#define FILM_OR_RING GLOBAL long* film
#endif

/// film_columns, film_rows: of the film, whose first pixel is pixel (film_x, film_y) of the picture. ring_row: where
/// the launch's first pixel is in the ring.
KERNEL LANE_HINT_OF(SCENE_LANES) void render(GLOBAL const real* geometry, GLOBAL const real* shading,
                                             GLOBAL const int* index, FILM_OR_RING, GLOBAL real* aov_reals,
                                             GLOBAL int* aov_ints, GLOBAL uint* counters, int width, int height,
                                             int x_first, int y_first, int columns, int rows, int span_columns,
                                             int film_x, int film_y, int film_columns, int film_rows, int sample_first,
                                             int sample_count, int ring_row, int ring_column, int ring_rows,
                                             int ring_columns) {
  int column = (int)get_global_id(0) * span_columns, row = (int)get_global_id(1);
  if (column >= columns || row >= rows) return;
  Scene scene = scene_of(geometry, shading, index, counters);
  Span span;
  span.x = x_first + column;
  span.y = y_first + row;
  span.columns = LANES == 1 ? 1 : min(span_columns, columns - column);
  span.width = width;
  span.height = height;
  span.column = 0;
  // Where the span's first pixel is in the film. Pixels around the film have no place there.
  int film_column = span.x - film_x, film_row = span.y - film_y;
  long slot = (long)film_row * (long)film_columns + (long)film_column;
  SpanFilm to;
  to.first_pixel = span_pixel(&span);
  to.sub_sums = sub_sums_of(&scene);
  to.pixel_words = (index[HEADER_SUMS] + HAS_MOMENT) * FILM_CHANNELS * FILM_SUM_WORDS;
  to.ring.rows = ring_rows;
  to.ring.columns = ring_columns;
  to.ring.sample_first = sample_first;
  to.ring.samples = sample_count;
#if HAS_SHARED_SAMPLES
  to.sums = 0;
  to.waiting = ring + ring_place(&to.ring, ring_row + row, ring_column + column);
  to.done = counters + COUNTERS + ring_pixel(&to.ring, ring_row + row, ring_column + column);
#else
  (void)ring_row;
  (void)ring_column;
  to.sums = film + slot * to.pixel_words;
  to.waiting = 0;
  to.done = counters + COUNTERS + slot;
#endif

  // Where no random number is drawn, all samples of a pixel are equal.
  int do_differ = SAMPLER_COUNT > 0;
  if (HAS_PIXEL_FILTER || HAS_COUNT_RAYS) do_differ = 1;
  int next = sample_first, end = sample_first + sample_count;
  if (HAS_LOOP_LIMIT) next = min(max(next, (int)*to.done), end);  // Continues where an earlier launch stopped.
  span.first = span.next = next;
  span.end = do_differ ? end : min(next + 1, end);
  to.times = do_differ ? 1 : end - next;
  FirstSamples first;
  first.reals = aov_reals + slot * AOV_REALS;
  first.ints = aov_ints + slot * AOV_INTS;
  first.first_pixel = to.first_pixel;
  first.from = max(-film_column, 0);
  first.end = film_row >= 0 && film_row < film_rows ? film_columns - film_column : 0;
  first.lanes = 0u;
  render_span_w(scene, span, first, to);
  if (HAS_LOOP_LIMIT) count_unfinished(&scene, next, (int)*to.done, end);
}
