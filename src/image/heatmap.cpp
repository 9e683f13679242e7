// SPDX-License-Identifier: MIT
// Maps of metrics in false colour.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "image/inferno.h"
#include "image/magma.h"
#include "image/metrics.h"

namespace strahl {
namespace {

/// Decades of relative difference that have a colour.
constexpr double decades = 3;

/// From 0 to 1; `largest` of the map.
double shade(Metric metric, double value, double largest) {
  if (metric == Metric::mae) return largest > 0 ? value / largest : 0;
  if (metric == Metric::relmse) return value > 0 ? std::clamp(1 + std::log10(value) / (2 * decades), 0.0, 1.0) : 0;
  return std::clamp(value, 0.0, 1.0);
}

}  // namespace

Image metric_heatmap(const Image& a, const Image& reference, Metric metric, double pixels_per_degree) {
  Channel map = metric_map(a, reference, metric, pixels_per_degree);
  if (metric == Metric::ssim) {
    for (double& similarity : map.values) similarity = 1 - similarity;
  }
  const double largest = map.values.empty() ? 0 : *std::max_element(map.values.begin(), map.values.end());
  const auto colours = is_seen(metric) ? magma : inferno;

  Image image;
  image.width = a.width;
  image.height = a.height;
  image.data.reserve(3 * map.values.size());
  for (const double value : map.values) {
    for (const float channel : colours(shade(metric, value, largest))) image.data.push_back(channel);
  }
  image.metadata["metric"] = metric_name(metric);
  image.metadata["largest difference"] = fmt::format("{}", largest);
  return image;
}

Image difference_heatmap(const Image& a, const Image& reference) { return metric_heatmap(a, reference, Metric::mae); }

}  // namespace strahl
