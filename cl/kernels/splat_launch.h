// SPDX-License-Identifier: MIT
// The film of a launch whose paths add to any pixel.
#ifndef STRAHL_KERNELS_SPLAT_LAUNCH_H
#define STRAHL_KERNELS_SPLAT_LAUNCH_H

#include "scene/scene.h"

/// Without `done`. The launch's pixels begin at (x_first, y_first) of the picture and film_first of the film.
FN SplatFilm splat_film_of(GLOBAL long* film, GLOBAL const int* index, int x_first, int y_first, int film_first,
                           int film_columns) {
  SplatFilm splats;
  splats.words = film;
  splats.x = x_first - film_first % film_columns;
  splats.y = y_first - film_first / film_columns;
  splats.columns = film_columns;
  splats.rows = index[HEADER_FILM_ROWS];
  splats.sums = index[HEADER_SUMS];
  splats.pixel_words = splats.sums * ((int)FILM_CHANNELS * (int)SPLAT_WORDS);
  return splats;
}

/// How far the pixel of the launch has come.
FN GLOBAL uint* done_of_paths(GLOBAL uint* counters, int film_first, int film_columns, int row, int column) {
  ulong slot = (ulong)film_first + (ulong)row * (ulong)film_columns + (ulong)column;
  return counters + COUNTERS + slot * DONE_OF_PATHS;
}

#endif
