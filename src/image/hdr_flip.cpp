// SPDX-License-Identifier: MIT
#include "image/hdr_flip.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace strahl {
namespace {

// Tone curve (p x^2 + q x) / (r x^2 + s x + t): K. Narkowicz, "ACES Filmic Tone Mapping Curve" (2016), with his scale
// of 0.6 for the exposure.
struct ToneCurve {
  static constexpr double p = 0.6 * 0.6 * 2.51, q = 0.6 * 0.03;
  static constexpr double r = 0.6 * 0.6 * 2.43, s = 0.6 * 0.59, t = 0.14;

  static double at(double x) { return std::clamp((p * x + q) * x / ((r * x + s) * x + t), 0.0, 1.0); }

  /// The value that is mapped to 0.85, where the curve begins to flatten.
  static double shoulder() {
    constexpr double level = 0.85;
    constexpr double a = p - level * r, b = q - level * s, c = -level * t;
    return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
  }
};

RgbChannels exposed(RgbChannels channels, double stops) {
  const double factor = std::exp2(stops);
  for (Channel& channel : channels) {
    for (double& value : channel.values) value = ToneCurve::at(factor * value);
  }
  return channels;
}

}  // namespace

Exposures flip_exposures(const RgbChannels& reference) {
  std::vector<double> luminances(reference[0].values.size());
  for (std::size_t i = 0; i < luminances.size(); ++i) {
    luminances[i] = 0.2126 * reference[0].values[i] + 0.7152 * reference[1].values[i] + 0.0722 * reference[2].values[i];
  }
  constexpr double least = std::numeric_limits<float>::epsilon();
  const double brightest = std::max(*std::max_element(luminances.begin(), luminances.end()), least);
  const auto middle = luminances.begin() + static_cast<std::ptrdiff_t>(luminances.size() / 2);
  std::nth_element(luminances.begin(), middle, luminances.end());
  const double shoulder = ToneCurve::shoulder();
  Exposures exposures{std::log2(shoulder / brightest), std::log2(shoulder / std::max(*middle, least)), 2};
  exposures.count = std::max(2, static_cast<int>(std::ceil(exposures.last - exposures.first)));
  return exposures;
}

Channel hdr_flip_map(const RgbChannels& a, const RgbChannels& reference, double pixels_per_degree) {
  const Exposures exposures = flip_exposures(reference);
  Channel largest(a[0].width, a[0].height);
  for (int i = 0; i < exposures.count; ++i) {
    const double stops = std::lerp(exposures.first, exposures.last, i / (exposures.count - 1.0));
    const Channel map = flip_map(exposed(a, stops), exposed(reference, stops), pixels_per_degree);
    for (std::size_t k = 0; k < map.values.size(); ++k) {
      largest.values[k] = std::max(largest.values[k], map.values[k]);
    }
  }
  return largest;
}

}  // namespace strahl
