// SPDX-License-Identifier: MIT
// The film: sums that do not depend on how samples were split into launches. Each sample's channel is rounded once to
// a fixed-point integer and added as an integer; docs/decisions/0002-film.md has the numbers.
#ifndef STRAHL_CORE_FILM_H
#define STRAHL_CORE_FILM_H

#include "core/counters.h"
#include "portable.h"

/// Units a sample may add at the most: 2^43, so that 2^19 samples a sub-sum (render/sampling.h) stay within 63 bits.
#define FILM_LIMIT R(8796093022208.0)

FN long film_units(const Scene* scene, real value, real scale) {
  real scaled = value * scale;
  if (!(scaled <= FILM_LIMIT && scaled >= -FILM_LIMIT)) {
    int is_number = scaled > FILM_LIMIT || scaled < -FILM_LIMIT;
    count_event(scene, is_number ? COUNT_SATURATED : COUNT_INVALID);
    scaled = is_number ? (scaled > R(0.0) ? FILM_LIMIT : -FILM_LIMIT) : R(0.0);
  }
  // The rest is exact; adding a half before truncating would round twice.
  long whole = (long)scaled;
  real rest = scaled - (real)whole;
  return whole + (rest >= R(0.5) ? 1 : (rest <= -R(0.5) ? -1 : 0));
}

#endif
