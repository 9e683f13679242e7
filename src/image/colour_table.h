// SPDX-License-Identifier: MIT
// False colours from a few entries of a map, joined by straight lines.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "image/srgb.h"

namespace strahl {

/// 8-bit sRGB at even steps from 0 to 1.
template <std::size_t count>
using ColourTable = std::array<std::array<int, 3>, count>;

/// Linear R, G, B for t in [0, 1].
template <std::size_t count>
[[nodiscard]] std::array<float, 3> table_colour(const ColourTable<count>& entries, double t) {
  const double position = t * (count - 1);
  const std::size_t entry = std::min(static_cast<std::size_t>(position), count - 2);
  std::array<float, 3> colour{};  // Interpolated as encoded values, in which the maps are even.
  for (std::size_t c = 0; c < 3; ++c) {
    const double code = std::lerp(entries[entry][c], entries[entry + 1][c], position - static_cast<double>(entry));
    colour[c] = static_cast<float>(linear_from_srgb(code / 255));
  }
  return colour;
}

}  // namespace strahl
