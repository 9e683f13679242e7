// SPDX-License-Identifier: MIT
// Pixel filters along one axis, whose integral is 1; distances in pixels from the middle.
#pragma once

#include "scene/model/scene.h"

namespace strahl::kinds {

/// The gaussian, lowered by its value at the radius as in Mitsuba.
class LoweredGaussian {
 public:
  LoweredGaussian(double radius, double stddev);

  /// |x| is the radius at the most.
  [[nodiscard]] double density(double x) const;
  /// x >= 0 with P(|X| > x) = share.
  [[nodiscard]] double quantile(double share) const;

 private:
  [[nodiscard]] double tail(double x) const;

  double radius_, stddev_;
  bool is_parabola_;
  double floor_, unit_, area_, beyond_, whole_ = 0;
};

/// To where the filter ends.
[[nodiscard]] double filter_radius(const Filter& filter);

/// |x| is the radius at the most. Of the lanczos the height is 1, and the integral near it. D. Mitchell, A. Netravali,
/// "Reconstruction Filters in Computer Graphics", 1988; K. Turkowski, "Filters for Common Resampling Tasks", 1990.
[[nodiscard]] double filter_density(const Filter& filter, double x);

/// Of those that may fall below 0 no place can be drawn.
[[nodiscard]] bool is_density(const Filter& filter);

/// What places of samples are drawn from that count in one pixel: a gaussian instead of those.
[[nodiscard]] Filter drawn_filter(const Filter& filter);

}  // namespace strahl::kinds
