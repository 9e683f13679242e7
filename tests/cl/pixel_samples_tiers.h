// SPDX-License-Identifier: MIT
// cl/film/pixel_samples_lanes.h of both tiers on the host, at the width that each has on a CPU; compiled in
// pixel_samples_f32.cpp and pixel_samples_f64.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "cl/math_tiers.h"

namespace strahl::test {

/// The sums of a pixel, and which sample goes to which (cl/film/sub_sums.h).
struct PixelSums {
  int count, sequences, turn_bits;
  std::vector<FilmWords> words;         ///< count x 3.
  std::array<std::uint32_t, 4> counts;  ///< Saturated, invalid.
};

/// Adds samples first, first + 1, ..., at most a pool's, in lanes and one by one. place: of the first in a pool, whose
/// other places have other pixels' samples.
template <class Real>
void add_in_lanes(PixelSums& sums, int first, int place, const std::vector<std::array<Real, 3>>& light);
template <class Real>
void add_one_by_one(PixelSums& sums, int first, const std::vector<std::array<Real, 3>>& light);

}  // namespace strahl::test
