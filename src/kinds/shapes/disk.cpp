// SPDX-License-Identifier: MIT
// Disk.
#include <cmath>
#include <numbers>

#include "kinds/box_around.h"
#include "kinds/shapes.h"

namespace strahl::kinds {

int primitive_count(const Disk&) { return 1; }

void extend(Extent& extent, const Disk& d) {
  extent.add(d.center, {std::hypot(d.axis_u.x, d.axis_v.x), std::hypot(d.axis_u.y, d.axis_v.y),
                        std::hypot(d.axis_u.z, d.axis_v.z)});
}

void check(Faults& faults, const Disk& d) {
  faults.require(is_finite(d.center) && is_finite(d.axis_u) && is_finite(d.axis_v), "the disk must be finite");
  const double u = length(d.axis_u), v = length(d.axis_v);
  faults.require(u > 0 && v > 0 && is_zero((u - v) / u) && is_zero(dot(normalized(d.axis_u), normalized(d.axis_v))),
                 "the disk's axes must be perpendicular, equally long and not zero");
  faults.require(!(u > 0 && v > 0) || !is_degenerate(d.axis_u, d.axis_v), "the disk's axes must span an area");
}

void pack(const Planes& to, const Disk& d) {
  const Vec3 u = to.frame.vector(d.axis_u);
  to.put(to.primitive().point(d.center).vector(near_unit(cross(d.axis_u, d.axis_v))).number(dot(u, u)));
}

bool faces_inward(const Disk&) { return false; }

std::optional<std::array<double, 9>> surface_frame(const Disk& d, const UploadFrame& frame) {
  const Vec3 u = frame.vector(d.axis_u), v = frame.vector(d.axis_v);
  const double inverse = 1 / dot(u, u);
  return nine(inverse * u, inverse * v, {});
}

void emit(AreaItems& items, const Disk& d, Primitives) {
  extend(items.extent(), d);
  items.flat(d.center, d.axis_u, d.axis_v, std::numbers::pi);
}

int first_of_area(const Disk&, int, bool) { return 0; }

Vec2 uv_rates(const Disk& d) { return {1 / length(d.axis_u), 1 / (2 * std::numbers::pi * length(d.axis_u))}; }

void move(Disk& d, const MapVec3& point, const MapVec3& vector) {
  d.center = point(d.center);
  d.axis_u = vector(d.axis_u);
  d.axis_v = vector(d.axis_v);
}

void scale(Disk&, double) {}

Mirrored mirror(Disk&, const MapVec3&) { return Mirrored::flipped; }

std::optional<Bounds<double>> bounds_disk(const double* p, double) {
  Bounds<double> box{};
  const double radius = std::sqrt(p[6]);
  for (std::size_t i = 0; i < 3; ++i)
    widen(box, i, p[i], p[i], reach_of_circle(radius, p[3 + i], p[3 + (i + 1) % 3], p[3 + (i + 2) % 3]));
  return box;
}

}  // namespace strahl::kinds
