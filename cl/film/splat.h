// SPDX-License-Identifier: MIT
// What light paths add to the film: to any pixel, while others add to it. A channel's sum has a word of 64 bits for
// each bin of SPLAT_BITS bits; a value is cut where bins meet, and its pieces are added atomically. Sums of integers do
// not depend on their order, so the words depend on the set of values alone (docs/decisions/0032-light-tracing.md).
// 2^31 pieces fit into a word.
//
// A place on the picture belongs to all pixels whose filters reach there. One of them is drawn, in proportion to the
// filter's density, and the value is multiplied by the sum of their densities, so that each pixel's expectation is its
// own filter's.
#ifndef STRAHL_FILM_SPLAT_H
#define STRAHL_FILM_SPLAT_H

#include "film/film.h"
#include "kernels/whole_loops.h"
#include "math/vec3.h"
#include "scene/scene.h"

#if ON_HOST
/// One thread traces.
FN void add_to_word(GLOBAL long* word, long piece) { *word += piece; }
#elif defined(cl_khr_int64_base_atomics)
#pragma OPENCL EXTENSION cl_khr_int64_base_atomics : enable
FN void add_to_word(GLOBAL long* word, long piece) { atom_add(word, piece); }
#else
/// The lower half, then the upper one with the carry, which the old lower half tells: carries commute as sums do.
FN void add_to_word(GLOBAL long* word, long piece) {
  GLOBAL uint* halves = (GLOBAL uint*)word;
  uint low = (uint)((ulong)piece & 0xffffffffu), high = (uint)((ulong)piece >> 32);
  uint before = low == 0u ? 0u : atomic_add(halves, low);
  if (before + low < before) ++high;
  if (high != 0u) atomic_add(halves + 1, high);
}
#endif

/// One channel. A float is kept whole down to 2^-SPLAT_ORIGIN; of a double at least the 33 leading bits are kept.
FN void splat_channel(const Scene* scene, GLOBAL long* words, real given) {
  FilmDigits number = film_digits(film_value(scene, given, 1));
  int place = number.power + SPLAT_ORIGIN;
  if (number.digits == 0 || place < 0) return;
  int bin = place / SPLAT_BITS, above = place % SPLAT_BITS;
  long high = (long)(number.digits >> (63 - above)), low = (long)(number.digits << (above + 1) >> (64 - SPLAT_BITS));
  add_to_word(words + bin, number.is_negative ? -high : high);
  if (low != 0 && bin > 0) add_to_word(words + bin - 1, number.is_negative ? -low : low);
}

/// Whether a path's splat of that number is to be made, and no other of that number is from then on. They are counted
/// from 1 on whether or not each is made: a path that the device has cut short is followed again, and each of its
/// splats is made once.
FN int is_splat_due(const Scene* scene, int number) {
  PRIVATE const SplatFilm* film = scene->splats;
  if (!HAS_LOOP_LIMIT) return 1;
  if ((uint)number <= film->done[DONE_SPLATS] || !loops_were_whole()) return 0;
  film->done[DONE_SPLATS] = (uint)number;
  return 1;
}

FN GLOBAL long* splat_sums(PRIVATE const SplatFilm* film, int column, int row) {
  ulong pixel = (ulong)row * (ulong)film->columns + (ulong)column;
  return film->words + pixel * (ulong)film->pixel_words;
}

/// To one sum of a pixel of the film. number: as of is_splat_due.
FN void splat_pixel(const Scene* scene, int column, int row, int sum, int number, real3 light) {
  if (!is_splat_due(scene, number)) return;
  GLOBAL long* words = splat_sums(scene->splats, column, row) + sum * ((int)FILM_CHANNELS * (int)SPLAT_WORDS);
  splat_channel(scene, words, light.x);
  splat_channel(scene, words + SPLAT_WORDS, light.y);
  splat_channel(scene, words + 2 * SPLAT_WORDS, light.z);
}

/// The light of a pixel's own camera path, which no other work-item adds to. Its sums are apart: it is a mean over the
/// pixel's samples, what light paths bring is one over those of the whole picture. number: as of is_splat_due.
FN void add_own_light(const Scene* scene, int column, int row, int sum, int number, real3 light) {
  PRIVATE const SplatFilm* film = scene->splats;
  if (!is_splat_due(scene, number)) return;
  int before = film->sums * ((int)FILM_CHANNELS * (int)SPLAT_WORDS) + sum * ((int)FILM_CHANNELS * (int)FILM_SUM_WORDS);
  film_add_color(scene, splat_sums(film, column, row) + before, light);
}

/// The filter's density at an offset from a pixel's middle. Of the two ends one counts, lest a box have both pixels at
/// their border.
FN real filter_density(GLOBAL const real* sensor, real offset) {
  GLOBAL const real* densities = sensor + SENSOR_REALS;
  real half_width = sensor[SENSOR_FILTER_HALF];
  if (!(-half_width <= offset && offset < half_width)) return R(0.0);
  real cell = (offset + half_width) / (R(2.0) * half_width) * (real)FILTER_CELLS;
  int i = min((int)cell, (int)FILTER_CELLS - 1);
  return real_fma(cell - (real)i, densities[i + 1] - densities[i], densities[i]);
}

typedef struct {
  int at;       ///< A column or a row.
  real weight;  ///< What the value is multiplied by; 0: no pixel.
} DrawnPixel;

/// Along one axis. place: in pixels from the picture's edge.
FN DrawnPixel drawn_pixel(GLOBAL const real* sensor, real place, real number) {
  real half_width = sensor[SENSOR_FILTER_HALF], middle = place - R(0.5), rest;
  int first = (int)real_floor(middle - half_width), last = (int)real_floor(middle + half_width) + 1;
  DrawnPixel drawn;
  drawn.at = first;
  drawn.weight = R(0.0);
  for (int i = first; i <= last; ++i) drawn.weight += filter_density(sensor, middle - (real)i);
  rest = number * drawn.weight;
  for (int i = first; i <= last; ++i) {
    real density = filter_density(sensor, middle - (real)i);
    if (density > R(0.0)) drawn.at = i;
    rest -= density;
    if (rest < R(0.0)) break;
  }
  return drawn;
}

/// At a place on the picture, in pixels from its upper left corner, not far off the film. u, v: within (0, 1).
FN void splat_place(const Scene* scene, real x, real y, real u, real v, int sum, int number, real3 light) {
  GLOBAL const real* sensor = scene->shading + scene->index[HEADER_SENSOR];
  PRIVATE const SplatFilm* film = scene->splats;
  DrawnPixel column = drawn_pixel(sensor, x, u), row = drawn_pixel(sensor, y, v);
  column.at -= film->x;
  row.at -= film->y;
  if (column.at < 0 || column.at >= film->columns || row.at < 0 || row.at >= film->rows) return;
  splat_pixel(scene, column.at, row.at, sum, number, scale3(column.weight * row.weight, light));
}

#endif
