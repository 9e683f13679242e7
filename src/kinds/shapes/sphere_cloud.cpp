// SPDX-License-Identifier: MIT
// Spheres that differ only in position and size, one primitive each. One that emits is a part (packing/shape_parts.h).
#include <algorithm>
#include <cmath>

#include "kinds/shapes.h"

namespace strahl::kinds {

int primitive_count(const SphereCloud& cloud) { return static_cast<int>(cloud.spheres.size()); }

void extend(Extent& extent, const SphereCloud& cloud) {
  for (const auto& [center, radius] : cloud.spheres) extent.add(center, {radius, radius, radius});
}

void check(Faults& faults, const SphereCloud& cloud) {
  faults.require(!cloud.spheres.empty(), "the cloud has no spheres");
  const auto is_sound = [](const SphereCloud::Ball& ball) {
    return is_finite(ball.center) && std::isfinite(ball.radius) && ball.radius > 0;
  };
  const auto fault = std::find_if_not(cloud.spheres.begin(), cloud.spheres.end(), is_sound);
  faults.require(fault == cloud.spheres.end(), "sphere {} must have a finite center and a finite radius > 0",
                 fault - cloud.spheres.begin());
  faults.require_orthonormal(cloud.frame);
}

void pack(const Planes& to, const SphereCloud& cloud) {
  for (const auto& [center, radius] : cloud.spheres) to.put(to.primitive().point(center).length(radius));
}

bool faces_inward(const SphereCloud&) { return false; }

std::optional<std::array<double, 9>> surface_frame(const SphereCloud& c, const UploadFrame&) {
  return nine(c.frame[0], c.frame[1], c.frame[2]);
}

void emit(AreaItems& items, const SphereCloud& cloud, Primitives primitives) {
  for (const int primitive : primitives) {
    const auto& [center, radius] = cloud.spheres[static_cast<std::size_t>(primitive)];
    emit(items, Sphere{center, radius, cloud.frame}, {});
  }
}

int first_of_area(const SphereCloud&, int part, bool) { return part; }

/// Those of the largest sphere.
Vec2 uv_rates(const SphereCloud& cloud) {
  double radius = 0;
  for (const SphereCloud::Ball& ball : cloud.spheres) radius = std::max(radius, ball.radius);
  return uv_rates(Sphere{{}, radius, cloud.frame});
}

void move(SphereCloud& cloud, const MapVec3& point, const MapVec3&) {
  for (SphereCloud::Ball& ball : cloud.spheres) ball.center = point(ball.center);
}

void scale(SphereCloud& cloud, double factor) {
  for (SphereCloud::Ball& ball : cloud.spheres) ball.radius *= factor;
}

Mirrored mirror(SphereCloud& cloud, const MapVec3& flip_x) {
  for (Vec3& axis : cloud.frame) axis = flip_x(axis);
  return Mirrored::alike;
}

}  // namespace strahl::kinds
