// SPDX-License-Identifier: MIT
// Differences in false colour.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "image/comparable.h"
#include "image/inferno.h"
#include "image/metrics.h"

namespace strahl {

Image difference_heatmap(const Image& a, const Image& reference) {
  const ComparedChannels channels = comparable_channels(a, reference);
  std::vector<double> differences;
  differences.reserve(a.index(0, a.height, 0) / a.channels.size());
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      double sum = 0;
      for (std::size_t c = 0; c < channels.a.size(); ++c) {
        sum += std::fabs(static_cast<double>(a.at(x, y, channels.a[c])) -
                         static_cast<double>(reference.at(x, y, channels.reference[c])));
      }
      differences.push_back(sum / static_cast<double>(channels.a.size()));
    }
  }
  const double largest = differences.empty() ? 0 : *std::max_element(differences.begin(), differences.end());

  Image map;
  map.width = a.width;
  map.height = a.height;
  for (const double difference : differences) {
    for (const float value : inferno(largest > 0 ? difference / largest : 0)) map.data.push_back(value);
  }
  map.metadata["largest difference"] = fmt::format("{}", largest);
  return map;
}

}  // namespace strahl
