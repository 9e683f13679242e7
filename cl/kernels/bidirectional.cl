// SPDX-License-Identifier: MIT
// As kernels/light_tracing.cl, for samples that are a path from a light and one from the camera.
#include "math/vec3.h"
#include "lanes/lane_ops.h"
#include "accel/traverse.h"
#include "film/film.h"
#include "kernels/splat_launch.h"
#include "kernels/path_parts.h"
#include "integrators/light_begin_lanes.h"
#include "integrators/both_ends_lanes.h"
#include "integrators/light_span_lanes.h"

/// Whole samples, as many at a time as there are lanes.
ONCE_FN void trace_both_ends_w(Scene scene, Span span) {
  Paths_w path;
  LightVertices_w light;
  paths_none_w(&path);
  path.sample = light_sample_begin_w(&scene, splat_uint_w(0u), splat_uint_w(0u));
  while (span_left(&span) > 0) {
    NewPaths_w begun = new_paths_w(&scene, &span);
    follow_both_ends_w(&scene, &path, &light, &begun);
    if (HAS_LOOP_LIMIT) {
      if (!loops_were_whole()) return;
      scene.splats->done[DONE_SAMPLE] = (uint)(span_left(&span) > 0 ? span.next : span.end);
      scene.splats->done[DONE_SPLATS] = 0u;
    }
  }
}

KERNEL LANE_HINT_OF(SCENE_LANES) void render(GLOBAL const real* geometry, GLOBAL const real* shading,
                                             GLOBAL const int* index, GLOBAL long* film, GLOBAL real* aov_reals,
                                             GLOBAL int* aov_ints, GLOBAL uint* counters, int width, int height,
                                             int x_first, int y_first, int columns, int rows, int span_columns,
                                             int film_first, int film_columns, int sample_first, int sample_count) {
  int column = (int)get_global_id(0) * span_columns, row = (int)get_global_id(1);
  if (column >= columns || row >= rows) return;
  (void)aov_reals;
  (void)aov_ints;
  SplatFilm splats = splat_film_of(film, index, x_first, y_first, film_first, film_columns);
  splats.pixel_words += splats.sums * ((int)FILM_CHANNELS * (int)FILM_SUM_WORDS);
  splats.done = done_of_paths(counters, film_first, film_columns, row, column);
  Scene scene = scene_of(geometry, shading, index, counters);
  scene.splats = &splats;
  Span span;
  span.x = x_first + column;
  span.y = y_first + row;
  span.columns = LANES == 1 ? 1 : min(span_columns, columns - column);
  span.width = width;
  span.height = height;
  span.first = span.next = sample_first;
  span.end = sample_first + sample_count;
  if (HAS_LOOP_LIMIT) span.first = span.next = min(max(sample_first, (int)splats.done[DONE_SAMPLE]), span.end);
  span.column = 0;
  trace_both_ends_w(scene, span);
  if (HAS_LOOP_LIMIT) count_unfinished(&scene, span.first, (int)splats.done[DONE_SAMPLE], span.end);
}
