// SPDX-License-Identifier: MIT
// What the film holds of samples that count in several pixels: besides their sums, those of their weights
// (docs/decisions/0035-shared-samples.md). They are the last words of a pixel.
#ifndef STRAHL_FILM_FILM_WEIGHTS_H
#define STRAHL_FILM_FILM_WEIGHTS_H

#include "film/sub_sums.h"
#include "portable.h"

/// Above the amount of any sample's weight, in its units. Conversions cut towards 0, which would round weights of
/// filters with negative parts up; lifted ones are positive. A float keeps 2^-8 of a unit beside it.
enum { WEIGHT_LIFT = 1 << 15 };

/// Words of a pixel's weights.
FN int words_of_weights(SubSums sums) { return (sums.count + 1) / 2; }

/// Adds to the sum of a sub-sum's weights: of one sum a word, else two of them share one, whose lower half borrows from
/// the upper where it is negative. weights: a pixel's words of weights.
FN void add_weight(GLOBAL long* weights, SubSums sums, int sub, int weight) {
  if (sums.count == 1)
    weights[0] += (long)weight;
  else
    weights[sub >> 1] += (long)weight * ((sub & 1) != 0 ? (long)1 << 32 : (long)1);
}

#endif
