// SPDX-License-Identifier: MIT
// Inverse cumulative distributions of the pixel filters, tabulated: samples are drawn from the filter with weight 1.
// M. Ernst, M. Stamminger, G. Greiner, "Filter Importance Sampling", IEEE Symposium on Interactive Ray Tracing, 2006.
#include <cmath>

#include "packing/cl_layout.h"
#include "packing/pack.h"

namespace strahl {
namespace {

/// Unnormalised integral of the gaussian, lowered by its value at the radius as in Mitsuba, from 0 to x.
double gaussian_integral(double x, double radius, double stddev) {
  const double floor = std::exp(-radius * radius / (2 * stddev * stddev));
  return stddev * std::sqrt(std::acos(-1.0) / 2) * std::erf(x / (stddev * std::sqrt(2.0))) - floor * x;
}

/// x >= 0 with P(|X| <= x) = p.
double gaussian_quantile(double p, double radius, double stddev) {
  const double whole = gaussian_integral(radius, radius, stddev);
  double low = 0, high = radius;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (gaussian_integral(middle, radius, stddev) < p * whole ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double upper_quantile(const Filter& filter, double p) {
  switch (filter.kind) {
    case FilterKind::box:
      return p * (filter.radius > 0 ? filter.radius : 0.5);
    case FilterKind::tent:
      return (1 - std::sqrt(1 - p)) * (filter.radius > 0 ? filter.radius : 1.0);
    case FilterKind::gaussian:
      return gaussian_quantile(p, filter.radius > 0 ? filter.radius : 4 * filter.stddev, filter.stddev);
  }
  return 0;
}

}  // namespace

std::vector<double> filter_quantiles(const Filter& filter, SamplerKind sampler) {
  std::vector<double> quantiles(layout::FILTER_CELLS + 1, 0.0);
  if (sampler == SamplerKind::centre) return quantiles;
  const int half = layout::FILTER_CELLS / 2;
  for (int i = 1; i <= half; ++i) {
    const double q = upper_quantile(filter, static_cast<double>(i) / half);
    quantiles[static_cast<std::size_t>(half + i)] = q;
    quantiles[static_cast<std::size_t>(half - i)] = -q;
  }
  return quantiles;
}

}  // namespace strahl
