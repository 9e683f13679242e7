// SPDX-License-Identifier: MIT
// A sample on its way into the film: cut into the bins of film/film_sum.h, in integers, so that no device's rounding or
// flushing of small numbers enters (docs/decisions/0002-film.md).
#ifndef STRAHL_FILM_FILM_H
#define STRAHL_FILM_FILM_H

#include "scene/counters.h"
#include "film/film_sum.h"
#include "math/vec3.h"
#include "portable.h"

/// The largest number that a sample may add: a float's, in every tier, so that no mean is infinite in a picture of
/// floats.
#define FILM_LARGEST R(0x1.fffffep+127)

/// What the film holds of a number: 0 of a NaN, at most FILM_LARGEST. The bits decide, because a compiler may assume
/// that there are no NaNs.
FN real film_held(real value) {
  bitsr sign = (bitsr)1 << (REAL_BITS - 1), bits = real_to_bits(value), size = bits & ~sign;
  if (size <= real_to_bits(FILM_LARGEST)) return value;
  int is_number = size <= (bitsr)REAL_EXPONENT_MASK << REAL_EXPONENT_SHIFT;
  return is_number ? bits_to_real((bits & sign) | real_to_bits(FILM_LARGEST)) : R(0.0);
}

/// What one channel of `times` samples adds. What the film does not hold as it is, is counted.
FN real film_value(const Scene* scene, real value, int times) {
  real held = film_held(value);
  bitsr bits = real_to_bits(held);
  if (bits != real_to_bits(value)) count_events(scene, bits != 0u ? COUNT_SATURATED : COUNT_INVALID, (uint)times);
  return held;
}

/// A number's digits, from 2^63 on, and the power of two that 2^63 is worth.
typedef struct {
  ulong digits;
  int power, is_negative;
} FilmDigits;

FN FilmDigits film_digits(real value) {
  bitsr bits = real_to_bits(value), sign = (bitsr)1 << (REAL_BITS - 1), leading = (bitsr)1 << REAL_EXPONENT_SHIFT;
  int exponent = (int)((bits & ~sign) >> REAL_EXPONENT_SHIFT);
  FilmDigits d;
  // Subnormal numbers have the smallest exponent, and no leading 1.
  d.digits = (ulong)((bits & (leading - 1u)) | (exponent > 0 ? leading : 0u)) << (63 - REAL_EXPONENT_SHIFT);
  d.power = max(exponent, 1) - (REAL_EXPONENT_MASK >> 1);
  d.is_negative = (bits & sign) != 0u;
  return d;
}

/// Cuts a film_value into bins. A float is kept whole; of a double at least the 41 leading bits are kept, and nothing
/// below 2^-220.
FN FilmBins film_bins_of(real value) {
  FilmDigits number = film_digits(value);
  ulong digits = number.digits;
  int place = number.power + FILM_ORIGIN;
  FilmBins bins;
  bins.top = 0;
  bins.high = bins.low = 0;
  if (digits == 0 || place < 0) return bins;
  int below = place / FILM_BIN_BITS, above = place % FILM_BIN_BITS;
  bins.top = below + 1;
  bins.high = (long)(digits >> (63 - above));
  bins.low = (long)(digits << (above + 1) >> (64 - FILM_BIN_BITS));
  if (number.is_negative) {
    bins.high = -bins.high;
    bins.low = -bins.low;
  }
  return bins;
}

/// Adds `times` equal samples of any value to one channel's sum.
SELDOM_FN void film_add_slowly(const Scene* scene, GLOBAL long* sum, real value, int times) {
  FilmBins bins = film_bins_of(film_value(scene, value, times));
  bins.high *= times;
  bins.low *= times;
  film_add(sum, bins);
}

/// The same of three channels, whose sums stand side by side.
FN void film_add_color_slowly(const Scene* scene, GLOBAL long* sum, real3 value, int times) {
  film_add_slowly(scene, sum, value.x, times);
  film_add_slowly(scene, sum + FILM_SUM_WORDS, value.y, times);
  film_add_slowly(scene, sum + 2 * FILM_SUM_WORDS, value.z, times);
}

/// Adds a sample to one channel's sum. Most samples are not above the sum's top. Then two products with powers of two
/// cut the sample as film_bins_of does: the products are exact, and numbers that a device flushes to zero lie below the
/// bins. In the outermost bins either may fail, so film_bins_of is used there.
FN void film_add_sample(const Scene* scene, GLOBAL long* sum, real value) {
  long high = sum[0], low = sum[1];
  int top = (int)(high & 3) << 2 | (int)(low & 3);
  int exponent = (int)(real_to_bits(value) >> REAL_EXPONENT_SHIFT) & REAL_EXPONENT_MASK;
  int bias = REAL_EXPONENT_MASK >> 1;
  // The first sample, where its top is the one of most pictures.
  if (top == 0 && exponent >= bias + FILM_BIN_BITS * (FILM_USUAL_TOP - 1) - FILM_ORIGIN &&
      exponent < bias + FILM_BIN_BITS * FILM_USUAL_TOP - FILM_ORIGIN) {
    top = FILM_USUAL_TOP;
    high = top >> 2;
    low = top & 3;
  }
  int end = bias - FILM_ORIGIN + top * FILM_BIN_BITS;  // The exponent field of the first number above.
  if (top < FILM_LEAST_TOP || top > FILM_MOST_TOP || exponent >= end) {
    film_add_slowly(scene, sum, value, 1);
    return;
  }
  // 2^0 in units of the top's beginning.
  real scale = bits_to_real((bitsr)(2 * bias - end + FILM_BIN_BITS) << REAL_EXPONENT_SHIFT);
  real scaled = value * scale;
  long above = (long)scaled;
  real rest = scaled - (real)above;
  sum[0] = high + above * 4;
  sum[1] = low + (long)(rest * R(0x1p+40)) * 4;
}

/// The same of three channels, whose sums stand side by side.
FN void film_add_color(const Scene* scene, GLOBAL long* sum, real3 value) {
  film_add_sample(scene, sum, value.x);
  film_add_sample(scene, sum + FILM_SUM_WORDS, value.y);
  film_add_sample(scene, sum + 2 * FILM_SUM_WORDS, value.z);
}

#endif
