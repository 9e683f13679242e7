// SPDX-License-Identifier: MIT
#include "kinds/upload_frame.h"

#include <algorithm>
#include <cmath>

namespace strahl {
namespace {

/// The distance from the camera to the farthest corner of the bounded shapes; without any, to the farthest plane.
double reach(const Scene& scene, const Vec3& eye) {
  if (const std::optional<Box> box = bounds(scene))
    return std::max(largest_component(box->min - eye), largest_component(box->max - eye));
  double farthest = 0;
  for (const Shape& shape : scene.shapes)
    if (const auto* plane = std::get_if<Plane>(&shape.geometry))
      farthest = std::max(farthest, std::fabs(dot(normalized(plane->normal), plane->point - eye)));
  return farthest;
}

}  // namespace

UploadFrame camera_frame(const Scene& scene) {
  UploadFrame frame{scene.camera.world_from_camera.translation(), 1};
  const double extent = reach(scene, frame.origin);
  if (extent > 0 && std::isfinite(extent)) frame.scale = std::ldexp(1.0, 12 - std::ilogb(extent));
  return frame;
}

}  // namespace strahl
