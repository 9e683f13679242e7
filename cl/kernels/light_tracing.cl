// SPDX-License-Identifier: MIT
// As kernels/render.cl, with the same arguments, for integrators whose paths begin on lights: a sample of a pixel is a
// path, which adds to any pixels. So the launch's pixels only say how many paths there are, and the film is whole.
#include "math/vec3.h"
#include "lanes/lane_ops.h"
#include "accel/traverse.h"
#include "film/film.h"
#include "kernels/splat_launch.h"
#include "kernels/path_parts.h"
#include "integrators/light_begin_lanes.h"
#include "integrators/light_paths_lanes.h"
#include "integrators/light_span_lanes.h"
#if LANES != 1
#include "integrators/path_pool_lanes.h"
#endif

#if LANES == 1
/// As follow_in_lanes of kernels/render.cl.
FN void trace_in_lanes_w(Scene scene, Span span) {
  Paths_w path;
  Branches_w branches;
  paths_none_w(&path);
  branches_none_w(&branches);
  while (span_left(&span) > 0 || any_w(path.alive)) {
    NewPaths_w begun = no_new_paths_w();
    if (!any_w(path.alive)) begun = new_paths_w(&scene, &span);
    follow_light_paths_w(&scene, &path, &branches, &begun);
    if (HAS_LOOP_LIMIT && !any_w(path.alive)) {
      if (!loops_were_whole()) return;
      scene.splats->done[DONE_SAMPLE] = (uint)(span_left(&span) > 0 ? span.next : span.end);
      scene.splats->done[DONE_SPLATS] = 0u;
    }
  }
}
#else
/// As follow_in_pools of kernels/render.cl.
ONCE_FN void trace_in_pools_w(Scene scene, Span span) {
  PathPool_w pool;
  Paths_w path;
  Branches_w branches;
  paths_none_w(&path);
  path.sample = light_sample_begin_w(&scene, splat_uint_w(0u), splat_uint_w(0u));
  branches_none_w(&branches);
  pool_none_w(&pool);
  while (span_left(&span) > 0 || pool.count > 0) {
    int are_new = pool.count == 0, count = are_new ? min((int)POOL_PATHS, span_left(&span)) : pool.count;
    for (int i = 0; i < count; i += LANES) {
      NewPaths_w begun = no_new_paths_w();
      if (are_new)
        begun = new_paths_w(&scene, &span);
      else
        pool_take_w(&pool, i, &path);
      follow_light_paths_w(&scene, &path, &branches, &begun);
      pool_put_w(&pool, i, are_new, count, &path);
    }
    pool_turn_w(&pool);
  }
}
#endif

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
#if LANES != 1
  trace_in_pools_w(scene, span);
#else
  trace_in_lanes_w(scene, span);
#endif
  if (HAS_LOOP_LIMIT) count_unfinished(&scene, span.first, (int)splats.done[DONE_SAMPLE], span.end);
}
