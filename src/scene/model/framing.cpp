// SPDX-License-Identifier: MIT
// The nearest face of the box fills a square window of 40 degrees but for a margin; what lies behind is smaller.
#include "scene/model/framing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace strahl {

Camera camera_framing(const std::optional<Box>& box) {
  constexpr double fov_degrees = 40;
  constexpr double margin = 1.05;
  const Box framed = box.value_or(Box{{-1, -1, -1}, {1, 1, 1}});
  const Vec3 center = 0.5 * framed.min + 0.5 * framed.max;
  const Vec3 half = 0.5 * framed.max - 0.5 * framed.min;
  const double face = std::max(half.x, half.y);
  const double extent = face > 0 ? face : (half.z > 0 ? half.z : 1.0);
  const double distance = margin * extent / std::tan(fov_degrees / 2 * std::numbers::pi / 180);
  Camera camera;
  camera.fov_degrees = fov_degrees;
  camera.fov_axis = FovAxis::smaller;
  camera.world_from_camera =
      Transform{{{{-1, 0, 0, center.x}, {0, 1, 0, center.y}, {0, 0, -1, framed.max.z + distance}}}};
  return camera;
}

double tan_half_width(double fov_degrees, FovAxis axis, double width, double height) {
  // Through long double, so that tan(45 degrees) is 1.
  const long double half = static_cast<long double>(fov_degrees) * std::acos(-1.0L) / 360.0L;
  const double tangent = static_cast<double>(std::tan(half));
  const bool wide = width >= height;
  switch (axis) {
    case FovAxis::x:
      return tangent;
    case FovAxis::y:
      return tangent * width / height;
    case FovAxis::diagonal:
      return tangent * width / std::hypot(width, height);
    case FovAxis::smaller:
      return wide ? tangent * width / height : tangent;
    case FovAxis::larger:
      return wide ? tangent : tangent * width / height;
  }
  return tangent;
}

}  // namespace strahl
