// SPDX-License-Identifier: MIT
// The mean over the sphere of what the texels of a latitude-longitude image hold.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

#include "scene/model/scene.h"

namespace strahl::kinds {

/// value(n): of texel n, row by row. By the solid angles that texels stand for; the image has at least 3 rows.
template <typename Value>
[[nodiscard]] double sphere_mean(const Texels& texels, Value value) {
  double sum = 0, weights = 0;
  for (int row = 0; row < texels.height; ++row) {
    const double weight = std::sin(std::numbers::pi * row / (texels.height - 1));
    for (int column = 0; column < texels.width; ++column) {
      sum += weight * value(static_cast<std::size_t>(row * texels.width + column));
      weights += weight;
    }
  }
  return weights > 0 ? sum / weights : 0;
}

}  // namespace strahl::kinds
