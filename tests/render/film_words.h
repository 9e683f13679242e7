// SPDX-License-Identifier: MIT
// Words of films by hand: what kernels would have added.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>

#include "packing/cl_layout.h"
#include "render/film.h"
#include "render/film_sum.h"

namespace strahl::test {

constexpr int sub_sum_number = layout::FILM_SUBSUMS;

/// Bins begin at 2^-20.
inline FilmBins bins_of(double value) { return {FILM_USUAL_TOP, std::llround(std::ldexp(value, 20)), 0}; }

/// Adds grey light to a sub-sum; behind the sub-sums are the squares.
inline void add_light(FilmSums& film, std::size_t pixel, int sub, double light) {
  for (int channel = 0; channel < layout::FILM_CHANNELS; ++channel) {
    const auto sum = static_cast<std::size_t>(sub * layout::FILM_CHANNELS + channel);
    film_add(&film.words[pixel * film.words_per_pixel() + sum * layout::FILM_SUM_WORDS], bins_of(light));
  }
}

/// Adds a multiple of film_weight_unit to the weight of a sub-sum.
inline void add_weight(FilmSums& film, std::size_t pixel, int sub, double weight) {
  const auto half = static_cast<std::size_t>(sub);
  std::int64_t& word = film.words[(pixel + 1) * film.words_per_pixel() - film.words_of_weights() + half / 2];
  const auto units = static_cast<std::uint64_t>(static_cast<std::int64_t>(weight / film_weight_unit));
  word = static_cast<std::int64_t>(static_cast<std::uint64_t>(word) + (units << (half % 2 * 32)));
}

}  // namespace strahl::test
