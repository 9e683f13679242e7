// SPDX-License-Identifier: MIT
// The second kernel of programs with HAS_SHARED_SAMPLES: samples from the ring into the film. A work-item is a span
// of pixels, as in the first. Included by kernels/render.cl, in PATH_LANES lanes.
#include "film/film_weights.h"
#include "film/shared_samples_lanes.h"

/// The pixels columns x rows from (column_first, row_first) of the film on, samples of each. ring_row, ring_column:
/// where in the ring the first row is whose samples count in them, and their first column.
KERNEL LANE_HINT_OF(SCENE_LANES) void share_samples(GLOBAL const real* geometry, GLOBAL const real* shading,
                                                    GLOBAL const int* index, GLOBAL long* film, GLOBAL const real* ring,
                                                    GLOBAL uint* counters, int column_first, int row_first, int columns,
                                                    int rows, int span_columns, int film_columns, int sample_first,
                                                    int samples, int ring_row, int ring_column, int ring_rows,
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
  share_span_w(&scene, &n, &to, min(span_columns, columns - column));
}
