// SPDX-License-Identifier: MIT
// Samples that count in several pixels, from the ring where the kernel of kernels/render.cl leaves them into the film
// (docs/decisions/0035-shared-samples.md). A work-item is a span of pixels, as there. A program of its own: it knows
// nothing of the scene but numbers, so that it is built once for all of them. Where the device ends loops, it goes on
// where an earlier launch stopped (kernels/whole_loops.h).
#include "math/vec3.h"
#include "lanes/lane_ops.h"
#include "scene/scene.h"
#include "film/span_film.h"
#include "film/film_weights.h"
#include "kernels/whole_loops.h"
#include "math/vec3_lanes.h"
#if LANES != 1
#include "film/pixel_samples_lanes.h"
#endif
#include "film/shared_samples_lanes.h"

/// The pixels columns x rows from (column_first, row_first) of the film on, samples of each. ring_row, ring_column:
/// where in the ring the first row is whose samples count in them, and their first column.
KERNEL LANE_HINT void share_samples(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index,
                                    GLOBAL long* film, GLOBAL const real* ring, GLOBAL uint* counters, int column_first,
                                    int row_first, int columns, int rows, int span_columns, int film_columns,
                                    int sample_first, int samples, int ring_row, int ring_column, int ring_rows,
                                    int ring_columns) {
  int column = (int)get_global_id(0) * span_columns, row = (int)get_global_id(1);
  if (column >= columns || row >= rows) return;
  Scene scene = scene_of(geometry, shading, index, counters);
  SharingFilm_w to;
  to.sums = sub_sums_of(&scene);
  to.pixel_words = (to.sums.count + HAS_MOMENT) * (FILM_CHANNELS * FILM_SUM_WORDS) + words_of_weights(to.sums);
  Neighbourhood_w n;
  n.reals = ring;
  n.ring.rows = ring_rows;
  n.ring.columns = ring_columns;
  n.ring.sample_first = sample_first;
  n.ring.samples = samples;
  n.row = ring_row + index[HEADER_TAP_REACH] + row;
  n.column = ring_column + column;
  n.reach = index[HEADER_TAP_REACH];
  n.sides = index[HEADER_TAP_SIDES];
  n.taps = shading + index[HEADER_TAPS];
  ulong pixel = (ulong)(row_first + row) * (ulong)film_columns + (ulong)(column_first + column);
  to.words = film + pixel * (ulong)to.pixel_words;
  to.done = counters + COUNTERS + ring_pixel(&n.ring, n.row, n.column);
  to.first = sample_first;
  if (HAS_LOOP_LIMIT) to.first = max(sample_first, (int)*to.done);  // Continues where an earlier launch stopped.
  share_span_w(&scene, &n, &to, min(span_columns, columns - column));
  if (HAS_LOOP_LIMIT) count_unfinished(&scene, to.first, (int)*to.done, sample_first + samples);
}
