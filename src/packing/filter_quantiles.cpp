// SPDX-License-Identifier: MIT
// Inverse cumulative distributions of the pixel filters, tabulated: samples are drawn from the filter with weight 1.
// M. Ernst, M. Stamminger, G. Greiner, "Filter Importance Sampling", IEEE Symposium on Interactive Ray Tracing, 2006.
#include <algorithm>
#include <cmath>

#include "kinds/filter_density.h"
#include "packing/cl_layout.h"
#include "packing/pack.h"

namespace strahl {
namespace {

/// Beyond so many deviations a gaussian is 1e-14 of its height.
constexpr double most_deviations = 8;
/// Its samples end earlier, in the midst of the last cell, which holds a millionth of them: it begins at 4.9
/// deviations.
constexpr double most_drawn_deviations = 5.5;

}  // namespace

std::vector<double> filter_quantiles(const Filter& asked, SamplerKind sampler) {
  std::vector<double> quantiles(layout::FILTER_CELLS + 1, 0.0);
  if (sampler == SamplerKind::centre) return quantiles;
  const Filter filter = kinds::drawn_filter(asked);
  const double half = kinds::filter_radius(filter);
  const kinds::LoweredGaussian gaussian(half, filter.stddev);
  const auto quantile = [&](double share) {
    switch (filter.kind) {
      case FilterKind::box:
        return (1 - share * share) * half;
      case FilterKind::tent:
        return (1 - share) * half;
      case FilterKind::gaussian:
        return std::min(gaussian.quantile(share * share), most_drawn_deviations * filter.stddev);
      case FilterKind::mitchell:
      case FilterKind::catmullrom:
      case FilterKind::lanczos:
        break;  // No densities.
    }
    return 0.0;
  };
  constexpr int cells = layout::FILTER_CELLS;
  for (int i = 0; i < cells; ++i) quantiles[static_cast<std::size_t>(i)] = quantile(static_cast<double>(i) / cells);
  return quantiles;
}

FilterDensities filter_densities(const Filter& asked) {
  const Filter filter = kinds::drawn_filter(asked);
  FilterDensities densities{kinds::filter_radius(filter), {}};
  // Cells stay narrow beside the bell however far off it is cut.
  if (filter.kind == FilterKind::gaussian)
    densities.half_width = std::min(densities.half_width, most_deviations * filter.stddev);
  constexpr int cells = layout::FILTER_CELLS;
  for (int i = 0; i <= cells; ++i)
    densities.values.push_back(kinds::filter_density(filter, (2.0 * i / cells - 1) * densities.half_width));
  return densities;
}

}  // namespace strahl
