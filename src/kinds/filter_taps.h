// SPDX-License-Identifier: MIT
// Pixel filters as weights of samples: how much a sample counts in the pixels around it.
#pragma once

#include <vector>

#include "scene/model/scene.h"

namespace strahl::kinds {

/// Of a filter along one axis, whose integral is 1. terms: layout::TAP_TERMS for each of the taps -reach to reach, of
/// each side (cl/scene/layout.h, HEADER_TAPS).
struct FilterTaps {
  int reach = 0;  ///< 0: samples count in their own pixel alone; they are drawn from the filter.
  int sides = 1;  ///< Filters with a kink have polynomials of their own on either side of a pixel's middle.
  std::vector<double> terms;
};

/// reach is 0 as well where the filter is wider than most_filter_reach, and where polynomials miss it: a box that ends
/// within a half of a pixel.
[[nodiscard]] FilterTaps filter_taps(const Filter& filter);

/// The taps of samples that count in their own pixel alone.
[[nodiscard]] FilterTaps single_tap();

inline constexpr int most_filter_reach = 4;

}  // namespace strahl::kinds
