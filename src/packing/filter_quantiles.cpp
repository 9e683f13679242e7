// SPDX-License-Identifier: MIT
// Inverse cumulative distributions of the pixel filters, tabulated: samples are drawn from the filter with weight 1.
// M. Ernst, M. Stamminger, G. Greiner, "Filter Importance Sampling", IEEE Symposium on Interactive Ray Tracing, 2006.
#include <algorithm>
#include <cmath>

#include "kinds/filter_taps.h"
#include "packing/cl_layout.h"
#include "packing/pack.h"

namespace strahl {
namespace {

/// The gaussian, lowered by its value at the radius as in Mitsuba; not normalised.
class LoweredGaussian {
 public:
  LoweredGaussian(double radius, double stddev)
      : radius_(radius),
        stddev_(stddev),
        // So wide a gaussian is 1 - (x / radius)^2 to 3e-7 of itself, while its two terms differ by fewer digits.
        is_parabola_(stddev > 1024 * radius),
        floor_(std::exp(-radius * radius / (2 * stddev * stddev))),
        unit_(stddev * std::sqrt(2.0)),
        area_(stddev * std::sqrt(std::acos(-1.0) / 2)),
        beyond_(std::erfc(radius / unit_)) {
    whole_ = is_parabola_ ? radius - radius * radius * radius / (3 * radius * radius)
                          : area_ * std::erf(radius / unit_) - floor_ * radius;
  }

  [[nodiscard]] double density(double x) const {
    const double height =
        is_parabola_ ? 1 - x * x / (radius_ * radius_) : std::exp(-x * x / (2 * stddev_ * stddev_)) - floor_;
    return height / (2 * whole_);
  }

  /// x >= 0 with P(|X| > x) = share.
  [[nodiscard]] double quantile(double share) const {
    double low = 0, high = radius_;
    for (;;) {
      const double middle = 0.5 * (low + high);
      if (middle == low || middle == high) return middle;
      (tail(middle) > share * whole_ ? low : high) = middle;
    }
  }

 private:
  /// The integral from x to the radius: of tails the difference of two from 0 has few digits.
  [[nodiscard]] double tail(double x) const {
    const double rest = radius_ - x;
    if (is_parabola_) return rest * rest * (2 * radius_ + x) / (3 * radius_ * radius_);
    // Near the radius both differences are small beside their terms: there the bell is a line and a parabola.
    const double slope = radius_ / (stddev_ * stddev_) * floor_;
    if (slope * rest < 1e-3 * floor_ && rest < 0.1 * radius_)
      return slope * rest * rest / 2 * (1 + rest * (radius_ / (stddev_ * stddev_) - 1 / radius_) / 3);
    return area_ * (std::erfc(x / unit_) - beyond_) - floor_ * rest;
  }

  double radius_, stddev_;
  bool is_parabola_;
  double floor_, unit_, area_, beyond_, whole_ = 0;
};

/// Beyond so many deviations a gaussian is 1e-14 of its height.
constexpr double most_deviations = 8;
/// Its samples end earlier, in the midst of the last cell, which holds a millionth of them: it begins at 4.9
/// deviations.
constexpr double most_drawn_deviations = 5.5;

}  // namespace

std::vector<double> filter_quantiles(const Filter& filter, SamplerKind sampler) {
  std::vector<double> quantiles(layout::FILTER_CELLS + 1, 0.0);
  if (sampler == SamplerKind::centre) return quantiles;
  const double half = kinds::filter_radius(filter);
  const LoweredGaussian gaussian(half, filter.stddev);
  const auto quantile = [&](double share) {
    switch (filter.kind) {
      case FilterKind::box:
        return (1 - share * share) * half;
      case FilterKind::tent:
        return (1 - share) * half;
      case FilterKind::gaussian:
        return std::min(gaussian.quantile(share * share), most_drawn_deviations * filter.stddev);
    }
    return 0.0;
  };
  constexpr int cells = layout::FILTER_CELLS;
  for (int i = 0; i < cells; ++i) quantiles[static_cast<std::size_t>(i)] = quantile(static_cast<double>(i) / cells);
  return quantiles;
}

FilterDensities filter_densities(const Filter& filter) {
  const double half = kinds::filter_radius(filter);
  const LoweredGaussian gaussian(half, filter.stddev);
  const auto density = [&](double offset) {
    switch (filter.kind) {
      case FilterKind::box:
        return 0.5 / half;
      case FilterKind::tent:
        return (1 - std::fabs(offset) / half) / half;
      case FilterKind::gaussian:
        return gaussian.density(offset);
    }
    return 0.0;
  };
  FilterDensities densities{half, {}};
  // Cells stay narrow beside the bell however far off it is cut.
  if (filter.kind == FilterKind::gaussian)
    densities.half_width = std::min(densities.half_width, most_deviations * filter.stddev);
  constexpr int cells = layout::FILTER_CELLS;
  for (int i = 0; i <= cells; ++i) densities.values.push_back(density((2.0 * i / cells - 1) * densities.half_width));
  return densities;
}

}  // namespace strahl
