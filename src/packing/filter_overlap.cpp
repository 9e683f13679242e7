// SPDX-License-Identifier: MIT
#include "packing/filter_overlap.h"

#include <cmath>

#include "kinds/filter_density.h"

namespace strahl {
namespace {

/// The integral of the product of two filters that are `shift` pixels apart, by the midpoint rule.
double shared(const Filter& filter, double radius, double shift) {
  constexpr int steps = 2048;
  const double from = shift - radius, width = 2 * radius - shift;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double x = from + (i + 0.5) / steps * width;
    sum += kinds::filter_density(filter, x) * kinds::filter_density(filter, x - shift);
  }
  return sum / steps * width;
}

}  // namespace

double noise_overlap(const Filter& filter) {
  const double radius = kinds::filter_radius(filter), own = shared(filter, radius, 0);
  double squares = 1;  // Along one axis; both have the same, and a pixel's correlation is the product of its axes'.
  for (int shift = 1; shift < 2 * radius; ++shift) squares += 2 * std::pow(shared(filter, radius, shift) / own, 2);
  return squares * squares;
}

}  // namespace strahl
