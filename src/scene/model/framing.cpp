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

}  // namespace strahl
