// SPDX-License-Identifier: MIT
// Maps of metrics in false colour.
#include <fmt/format.h>

#include <algorithm>

#include "image/inferno.h"
#include "image/magma.h"
#include "image/metrics.h"

namespace strahl {

Image metric_heatmap(const Image& a, const Image& reference, Metric metric, double pixels_per_degree) {
  Channel map = metric_map(a, reference, metric, pixels_per_degree);
  if (metric == Metric::ssim) {
    for (double& similarity : map.values) similarity = 1 - similarity;
  }
  const double largest = map.values.empty() ? 0 : *std::max_element(map.values.begin(), map.values.end());
  const double scale = metric == Metric::mae && largest > 0 ? 1 / largest : 1;
  const auto colours = is_seen(metric) ? magma : inferno;

  Image image;
  image.width = a.width;
  image.height = a.height;
  image.data.reserve(3 * map.values.size());
  for (const double value : map.values) {
    for (const float channel : colours(std::clamp(value * scale, 0.0, 1.0))) image.data.push_back(channel);
  }
  image.metadata["metric"] = metric_name(metric);
  image.metadata["largest difference"] = fmt::format("{}", largest);
  return image;
}

Image difference_heatmap(const Image& a, const Image& reference) { return metric_heatmap(a, reference, Metric::mae); }

}  // namespace strahl
