// SPDX-License-Identifier: MIT
#include "kinds/upload_frame.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "kinds/shapes.h"

namespace strahl {
namespace {

/// Exponents of two, of the frame's units.
constexpr int usual_reach = 12, most_reach = 39, least_side = -26;

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

/// The largest side of the smallest bounded shape; 0: there is none.
double smallest_side(const Scene& scene) {
  double smallest = 0;
  for (const Shape& shape : scene.shapes) {
    const std::optional<Box> box = bounds(shape);
    const double side = box ? largest_component(box->max - box->min) : 0;
    if (side > 0 && (smallest == 0 || side < smallest)) smallest = side;
  }
  return smallest;
}

}  // namespace

UploadFrame camera_frame(const Scene& scene) {
  UploadFrame frame{scene.camera.world_from_camera.translation(), 1, true};
  const double extent = reach(scene, frame.origin);
  if (!(extent > 0) || !std::isfinite(extent)) return frame;
  const double side = smallest_side(scene);
  int exponent = usual_reach - std::ilogb(extent);
  if (side > 0) exponent = std::max(exponent, std::min(least_side - std::ilogb(side), most_reach - std::ilogb(extent)));
  frame.scale = std::ldexp(1.0, exponent);
  return frame;
}

}  // namespace strahl
