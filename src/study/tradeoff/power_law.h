// SPDX-License-Identifier: MIT
// y = factor * x^slope through points: a straight line between their logarithms by least squares, with the interval of
// Student's t for its slope (N. R. Draper, H. Smith, "Applied Regression Analysis", 1998, chapter 1).
#pragma once

#include <optional>
#include <utility>
#include <vector>

namespace strahl {

struct PowerLaw {
  double slope = 0;
  double slope_low = 0, slope_high = 0;  ///< 95 %.
  double factor = 1;
  int points = 0;  ///< That it was fitted to.
};

/// Of those points whose x and y are above 0; none where they are fewer than three, which have no interval, or where
/// all have the same x.
[[nodiscard]] std::optional<PowerLaw> fit_power_law(const std::vector<std::pair<double, double>>& points);

}  // namespace strahl
