// SPDX-License-Identifier: MIT
#include "packing/filter_overlap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "packing/pack.h"

namespace strahl {
namespace {

/// Linear between the table's values; x lies within the filter.
double density_at(const FilterDensities& densities, double x) {
  const auto cells = static_cast<double>(densities.values.size() - 1);
  const double place = std::clamp((x / densities.half_width + 1) / 2 * cells, 0.0, cells);
  const double below = std::min(std::floor(place), cells - 1), share = place - below;
  const double* const value = &densities.values[static_cast<std::size_t>(below)];
  return value[0] * (1 - share) + value[1] * share;
}

/// The integral of the product of two filters that are `shift` pixels apart, by the midpoint rule.
double shared(const FilterDensities& densities, double shift) {
  constexpr int steps = 2048;
  const double from = shift - densities.half_width, width = 2 * densities.half_width - shift;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double x = from + (i + 0.5) / steps * width;
    sum += density_at(densities, x) * density_at(densities, x - shift);
  }
  return sum / steps * width;
}

}  // namespace

double noise_overlap(const Filter& filter) {
  const FilterDensities densities = filter_densities(filter);
  const double own = shared(densities, 0);
  double squares = 1;  // Along one axis; both have the same, and a pixel's correlation is the product of its axes'.
  for (int shift = 1; shift < 2 * densities.half_width; ++shift)
    squares += 2 * std::pow(shared(densities, shift) / own, 2);
  return squares * squares;
}

}  // namespace strahl
