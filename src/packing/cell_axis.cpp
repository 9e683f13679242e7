// SPDX-License-Identifier: MIT
#include "packing/cell_axis.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace strahl {
namespace {

int wrapped(std::int64_t texel, int size, TextureWrap wrap) {
  const std::int64_t period = wrap == TextureWrap::mirror ? 2 * std::int64_t{size} : size;
  const std::int64_t inside = ((texel % period) + period) % period;
  return static_cast<int>(inside < size ? inside : period - 1 - inside);
}

/// first, last: texels of the infinite row.
std::vector<int> texels_between(double first, double last, int size, TextureWrap wrap) {
  std::vector<int> texels;
  if (wrap == TextureWrap::clamp) {
    const auto low = static_cast<int>(std::clamp(first, 0.0, size - 1.0));
    const auto high = static_cast<int>(std::clamp(last, 0.0, size - 1.0));
    for (int t = low; t <= high; ++t) texels.push_back(t);
    return texels;
  }
  if (last - first >= 2.0 * size) {
    texels.resize(static_cast<std::size_t>(size));
    std::iota(texels.begin(), texels.end(), 0);
    return texels;
  }
  for (auto t = static_cast<std::int64_t>(first); t <= static_cast<std::int64_t>(last); ++t)
    texels.push_back(wrapped(t, size, wrap));
  std::sort(texels.begin(), texels.end());
  texels.erase(std::unique(texels.begin(), texels.end()), texels.end());
  return texels;
}

}  // namespace

CellAxis cells_over(const std::array<double, 2>& range, int size, double most) {
  constexpr double rounding = 1e-6;
  for (CellAxis axis;; axis.cell *= 2) {
    const double low = std::floor(range[0] * size / axis.cell + rounding);
    const double high = std::ceil(range[1] * size / axis.cell - rounding);
    if (high - low > most) continue;
    axis.first = low;
    axis.count = std::max(static_cast<int>(high - low), 1);
    return axis;
  }
}

std::vector<std::vector<int>> texels_of_cells(const CellAxis& axis, int size, TextureWrap wrap) {
  std::vector<std::vector<int>> all(static_cast<std::size_t>(axis.count));
  for (int i = 0; i < axis.count; ++i) {
    const double first = (axis.first + i) * axis.cell;
    all[static_cast<std::size_t>(i)] = texels_between(first - 1, first + axis.cell, size, wrap);
  }
  return all;
}

}  // namespace strahl
