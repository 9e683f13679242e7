// SPDX-License-Identifier: MIT
// The film's arithmetic of cl/film/film_sum.h for the host: one definition, used by both sides.
#pragma once

#include <bit>
#include <cstdint>

#include "packing/cl_layout.h"

namespace strahl {
static_assert(sizeof(long) == sizeof(std::int64_t), "cl/film/film_sum.h takes the device's long");

#define FN inline
#define GLOBAL
#include "../../cl/film/film_sum.h"
#undef FN
#undef GLOBAL

/// Rounded at most twice: each bin to 53 bits, and their sum.
[[nodiscard]] inline double value_of(const FilmBins& bins) {
  constexpr double bin = std::int64_t{1} << FILM_BIN_BITS;
  const int exponent = (bins.top - 2) * FILM_BIN_BITS - FILM_ORIGIN;
  // 2^exponent, without std::ldexp, which is slow for every pixel (docs/decisions/0002-film.md).
  const auto unit = std::bit_cast<double>(static_cast<std::uint64_t>(1023 + exponent) << 52);
  return (static_cast<double>(bins.high) * bin + static_cast<double>(bins.low)) * unit;
}

/// SPLAT_WORDS words of cl/film/splat.h: each is rounded to 53 bits, and so is their sum, from the lowest word on.
[[nodiscard]] inline double value_of_splats(const std::int64_t* words) {
  constexpr double bin = std::int64_t{1} << layout::SPLAT_BITS;
  auto unit = std::bit_cast<double>(static_cast<std::uint64_t>(1023 - layout::SPLAT_ORIGIN) << 52);
  double sum = 0;
  for (int k = 0; k < layout::SPLAT_WORDS; ++k, unit *= bin) sum += static_cast<double>(words[k]) * unit;
  return sum;
}

}  // namespace strahl
