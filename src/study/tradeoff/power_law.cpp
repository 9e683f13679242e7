// SPDX-License-Identifier: MIT
#include "study/tradeoff/power_law.h"

#include <array>
#include <cmath>

namespace strahl {
namespace {

/// The 97.5 % quantile of Student's t. Beyond the table, the expansion of R. A. Fisher and E. A. Cornish, "The
/// Percentile Points of Distributions Having Known Cumulants", Technometrics 2(2), 1960, to its second term.
double t_975(int degrees) {
  constexpr std::array<double, 10> table{12.7062, 4.3027, 3.1824, 2.7764, 2.5706,
                                         2.4469,  2.3646, 2.3060, 2.2622, 2.2281};
  if (degrees <= static_cast<int>(table.size())) return table[static_cast<std::size_t>(degrees - 1)];
  constexpr double z = 1.959964;
  const double n = degrees;
  return z + (z * z * z + z) / (4 * n) + (5 * std::pow(z, 5) + 16 * z * z * z + 3 * z) / (96 * n * n);
}

}  // namespace

std::optional<PowerLaw> fit_power_law(const std::vector<std::pair<double, double>>& points) {
  std::vector<std::pair<double, double>> logs;
  for (const auto& [x, y] : points)
    if (x > 0 && y > 0) logs.emplace_back(std::log(x), std::log(y));
  if (logs.size() < 3) return std::nullopt;

  const double n = static_cast<double>(logs.size());
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0, residuals = 0;
  for (const auto& [x, y] : logs) {
    mean_x += x / n;
    mean_y += y / n;
  }
  for (const auto& [x, y] : logs) {
    xx += (x - mean_x) * (x - mean_x);
    xy += (x - mean_x) * (y - mean_y);
  }
  if (!(xx > 0)) return std::nullopt;
  PowerLaw law;
  law.points = static_cast<int>(logs.size());
  law.slope = xy / xx;
  law.factor = std::exp(mean_y - law.slope * mean_x);
  for (const auto& [x, y] : logs) {
    const double residual = y - mean_y - law.slope * (x - mean_x);
    residuals += residual * residual;
  }
  const double half = t_975(law.points - 2) * std::sqrt(residuals / (n - 2) / xx);
  law.slope_low = law.slope - half;
  law.slope_high = law.slope + half;
  return law;
}

}  // namespace strahl
