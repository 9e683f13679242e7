// SPDX-License-Identifier: MIT
// Inverse cumulative distributions of the pixel filters, tabulated: samples are drawn from the filter with weight 1.
// M. Ernst, M. Stamminger, G. Greiner, "Filter Importance Sampling", IEEE Symposium on Interactive Ray Tracing, 2006.
#include <algorithm>
#include <cmath>

#include "packing/cl_layout.h"
#include "packing/pack.h"

namespace strahl {
namespace {

/// So wide a gaussian is 1 - (x / radius)^2 to 3e-7 of itself, while the difference of its two terms has fewer digits.
bool is_parabola(double radius, double stddev) { return stddev > 1024 * radius; }

/// Unnormalised integral of the gaussian, lowered by its value at the radius as in Mitsuba, from 0 to x.
double gaussian_integral(double x, double radius, double stddev) {
  if (is_parabola(radius, stddev)) return x - x * x * x / (3 * radius * radius);
  const double floor = std::exp(-radius * radius / (2 * stddev * stddev));
  return stddev * std::sqrt(std::acos(-1.0) / 2) * std::erf(x / (stddev * std::sqrt(2.0))) - floor * x;
}

/// From x to the radius: of tails the difference of two integrals has few digits.
double gaussian_tail(double x, double radius, double stddev) {
  if (is_parabola(radius, stddev)) return (radius - x) * (radius - x) * (2 * radius + x) / (3 * radius * radius);
  const double floor = std::exp(-radius * radius / (2 * stddev * stddev)), unit = stddev * std::sqrt(2.0);
  // Near the radius both differences are small beside their terms: there the bell is a line and a parabola.
  const double rest = radius - x, slope = radius / (stddev * stddev) * floor;
  if (slope * rest < 1e-3 * floor && rest < 0.1 * radius)
    return slope * rest * rest / 2 * (1 + rest * (radius / (stddev * stddev) - 1 / radius) / 3);
  return stddev * std::sqrt(std::acos(-1.0) / 2) * (std::erfc(x / unit) - std::erfc(radius / unit)) - floor * rest;
}

/// x >= 0 with P(|X| > x) = tail.
double gaussian_quantile(double tail, double radius, double stddev) {
  const double whole = gaussian_integral(radius, radius, stddev);
  double low = 0, high = radius;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (gaussian_tail(middle, radius, stddev) > tail * whole ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Beyond so many deviations a gaussian is 1e-14 of its height.
constexpr double most_deviations = 8;
/// Its samples end earlier, in the midst of the last cell, which holds a millionth of them: it begins at 4.9
/// deviations.
constexpr double most_drawn_deviations = 5.5;

double half_width(const Filter& filter) {
  if (filter.radius > 0) return filter.radius;
  switch (filter.kind) {
    case FilterKind::box:
      return 0.5;
    case FilterKind::tent:
      return 1;
    case FilterKind::gaussian:
      return 4 * filter.stddev;
  }
  return 0;
}

/// x >= 0 with P(|X| > x) = share^2.
double quantile(const Filter& filter, double share) {
  switch (filter.kind) {
    case FilterKind::box:
      return (1 - share * share) * half_width(filter);
    case FilterKind::tent:
      return (1 - share) * half_width(filter);
    case FilterKind::gaussian:
      return std::min(gaussian_quantile(share * share, half_width(filter), filter.stddev),
                      most_drawn_deviations * filter.stddev);
  }
  return 0;
}

double density(const Filter& filter, double offset) {
  const double half = half_width(filter), x = std::fabs(offset);
  switch (filter.kind) {
    case FilterKind::box:
      return 0.5 / half;
    case FilterKind::tent:
      return (1 - x / half) / half;
    case FilterKind::gaussian: {
      if (is_parabola(half, filter.stddev))
        return (1 - x * x / (half * half)) / (2 * gaussian_integral(half, half, filter.stddev));
      const double variance = filter.stddev * filter.stddev;
      const double lowered = std::exp(-x * x / (2 * variance)) - std::exp(-half * half / (2 * variance));
      return lowered / (2 * gaussian_integral(half, half, filter.stddev));
    }
  }
  return 0;
}

}  // namespace

std::vector<double> filter_quantiles(const Filter& filter, SamplerKind sampler) {
  std::vector<double> quantiles(layout::FILTER_CELLS + 1, 0.0);
  if (sampler == SamplerKind::centre) return quantiles;
  constexpr int cells = layout::FILTER_CELLS;
  for (int i = 0; i < cells; ++i)
    quantiles[static_cast<std::size_t>(i)] = quantile(filter, static_cast<double>(i) / cells);
  return quantiles;
}

FilterDensities filter_densities(const Filter& filter) {
  FilterDensities densities{half_width(filter), {}};
  // Cells stay narrow beside the bell however far off it is cut.
  if (filter.kind == FilterKind::gaussian)
    densities.half_width = std::min(densities.half_width, most_deviations * filter.stddev);
  constexpr int cells = layout::FILTER_CELLS;
  for (int i = 0; i <= cells; ++i)
    densities.values.push_back(density(filter, (2.0 * i / cells - 1) * densities.half_width));
  return densities;
}

}  // namespace strahl
