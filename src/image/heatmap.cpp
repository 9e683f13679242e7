// SPDX-License-Identifier: MIT
// Differences in false colour: the map "inferno" of Nathaniel Smith and Stefan van der Walt ("A Better Default Colormap
// for Matplotlib", SciPy 2015; CC0), whose lightness grows evenly. Ten of its entries are joined by straight lines.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "image/comparable.h"
#include "image/metrics.h"
#include "image/srgb.h"

namespace strahl {
namespace {

// inferno at 0, 1/9, ..., 1: 8-bit sRGB.
constexpr std::array<std::array<int, 3>, 10> inferno{{{0x00, 0x00, 0x04},
                                                      {0x1b, 0x0c, 0x42},
                                                      {0x4b, 0x0c, 0x6b},
                                                      {0x78, 0x1c, 0x6d},
                                                      {0xa5, 0x2c, 0x60},
                                                      {0xcf, 0x44, 0x46},
                                                      {0xed, 0x69, 0x25},
                                                      {0xfb, 0x9a, 0x06},
                                                      {0xf7, 0xd0, 0x3c},
                                                      {0xfc, 0xff, 0xa4}}};

/// t in [0, 1]; interpolated as encoded values, in which the map is even.
std::array<float, 3> linear_colour(double t) {
  const double position = t * (inferno.size() - 1);
  const std::size_t entry = std::min(static_cast<std::size_t>(position), inferno.size() - 2);
  std::array<float, 3> colour{};
  for (std::size_t c = 0; c < 3; ++c) {
    const double code = std::lerp(inferno[entry][c], inferno[entry + 1][c], position - static_cast<double>(entry));
    colour[c] = static_cast<float>(linear_from_srgb(code / 255));
  }
  return colour;
}

}  // namespace

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
    for (const float value : linear_colour(largest > 0 ? difference / largest : 0)) map.data.push_back(value);
  }
  map.metadata["largest difference"] = fmt::format("{}", largest);
  return map;
}

}  // namespace strahl
