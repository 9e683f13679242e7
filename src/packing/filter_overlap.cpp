// SPDX-License-Identifier: MIT
#include "packing/filter_overlap.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include "kinds/filter_density.h"

namespace strahl {
namespace {

constexpr std::size_t cells_a_pixel = 256;

/// At the cells' middles.
std::vector<double> values_of(const Filter& filter) {
  const double radius = kinds::filter_radius(filter);
  std::vector<double> values;
  for (double x = -radius + 0.5 / cells_a_pixel; x < radius; x += 1.0 / cells_a_pixel)
    values.push_back(kinds::filter_density(filter, x));
  return values;
}

/// The integral of the product of two filters that are so many cells apart, in cells.
double shared(const std::vector<double>& values, std::size_t shift) {
  double sum = 0;
  for (std::size_t i = shift; i < values.size(); ++i) sum += values[i] * values[i - shift];
  return sum;
}

}  // namespace

double noise_overlap(const Filter& filter) {
  const std::vector<double> values = values_of(filter);
  const double own = shared(values, 0);
  double squares = 1;  // Along one axis; both have the same, and a pixel's correlation is the product of its axes'.
  for (std::size_t shift = cells_a_pixel; shift < values.size(); shift += cells_a_pixel)
    squares += 2 * std::pow(shared(values, shift) / own, 2);
  return squares * squares;
}

}  // namespace strahl
