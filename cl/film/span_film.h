// SPDX-License-Identifier: MIT
// Where the samples of a span of pixels go. Needs Scene.
#ifndef STRAHL_FILM_SPAN_FILM_H
#define STRAHL_FILM_SPAN_FILM_H

#include "film/film.h"
#include "film/moments.h"
#include "film/sample_ring.h"
#include "film/sub_sums.h"

typedef struct {
  GLOBAL long* sums;  ///< The first pixel's in the film; the others' follow.
  GLOBAL uint* done;  ///< The word behind the counters (scene/layout.h); used only where a span is one pixel.
  SubSums sub_sums;
  int first_pixel;       ///< Its number in the picture.
  int pixel_words;       ///< Words of a pixel in the film.
  int times;             ///< Each sample counts so many times.
  SampleRing ring;       ///< With HAS_SHARED_SAMPLES samples go there,
  GLOBAL real* waiting;  ///< the first pixel's from here on.
} SpanFilm;

/// A sample of a pixel in the ring.
FN GLOBAL real* place_in_ring(const SpanFilm* film, int pixel, int sample) {
  return film->waiting + (sample - film->ring.sample_first) * ring_sample_step(&film->ring) +
         (pixel - film->first_pixel) * ring_pixel_step(&film->ring);
}

/// For the pixels around it, that this one's is among. What is not finite would spread: it counts as in the film.
FN void keep_sample(const Scene* scene, const SpanFilm* film, int pixel, int sample, real3 light) {
  GLOBAL real* at = place_in_ring(film, pixel, sample);
  int step = ring_plane(&film->ring);
  at[RING_R * step] = film_value(scene, light.x, 1);
  at[RING_G * step] = film_value(scene, light.y, 1);
  at[RING_B * step] = film_value(scene, light.z, 1);
  if (HAS_LOOP_LIMIT) *film->done = (uint)(sample + 1);
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
  film_add_color(scene, sum, light);
  if (HAS_MOMENT) add_squares(scene, pixel_sums + sums.count * (FILM_CHANNELS * FILM_SUM_WORDS), light, 1);
}

/// Adds `times` samples of a pixel from `sample` on, all with this radiance.
FN void add_to_film(const Scene* scene, const SpanFilm* film, int pixel, int sample, real3 light) {
  GLOBAL uint* done = film->done;
  SubSums sums = film->sub_sums;
  int times = film->times;
  // A black sample need not touch the film.
  if (light.x == R(0.0) && light.y == R(0.0) && light.z == R(0.0)) {
    if (HAS_LOOP_LIMIT) *done = (uint)(sample + times);
    return;
  }
  GLOBAL long* pixel_sums = film->sums + (ulong)(pixel - film->first_pixel) * (ulong)film->pixel_words;
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
    film_add_color_slowly(scene, sum, light, number);
  }
  if (HAS_MOMENT) add_squares(scene, pixel_sums + sums.count * (FILM_CHANNELS * FILM_SUM_WORDS), light, times);
}

#endif
