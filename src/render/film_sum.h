// SPDX-License-Identifier: MIT
// The film's arithmetic of cl/core/film_sum.h for the host: one definition, used by both sides.
#pragma once

#include <cmath>
#include <cstdint>

namespace strahl {
static_assert(sizeof(long) == sizeof(std::int64_t), "cl/core/film_sum.h takes the device's long");

#define FN inline
#define GLOBAL
#include "../../cl/core/film_sum.h"
#undef FN
#undef GLOBAL

/// Rounded twice at the most: each bin to 53 bits, and their sum.
[[nodiscard]] inline double value_of(const FilmBins& bins) {
  const int exponent = (bins.top - 2) * FILM_BIN_BITS - FILM_ORIGIN;
  return std::ldexp(std::ldexp(static_cast<double>(bins.high), FILM_BIN_BITS) + static_cast<double>(bins.low),
                    exponent);
}

}  // namespace strahl
