// SPDX-License-Identifier: MIT
// The mean over the sphere of what a latitude-longitude image holds, bilinear between its texels.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

#include "scene/model/scene.h"

namespace strahl::kinds {

/// value(n): of texel n, row by row. By the cells between four texels, as directions are drawn
/// (packing/pack_environment.h): so light at a pole alone counts too. The image has at least 3 rows.
template <typename Value>
[[nodiscard]] double sphere_mean(const Texels& texels, Value value) {
  double sum = 0, weights = 0;
  const int cells = texels.height - 1;
  // Of a row of cells, which begins at that row of texels; there are none beyond the poles.
  const auto sine = [&](int row) {
    return row < 0 || row >= cells ? 0 : std::sin(std::numbers::pi * (row + 0.5) / cells);
  };
  for (int row = 0; row < texels.height; ++row) {
    const double weight = sine(row - 1) + sine(row);
    for (int column = 0; column < texels.width; ++column) {
      sum += weight * value(static_cast<std::size_t>(row * texels.width + column));
      weights += weight;
    }
  }
  return weights > 0 ? sum / weights : 0;
}

}  // namespace strahl::kinds
