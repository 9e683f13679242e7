// SPDX-License-Identifier: MIT
// Sphere, and clouds of them (shapes/sphere_cloud.cpp).
#include <numbers>

#include "kinds/box_around.h"
#include "kinds/shapes.h"

namespace strahl::kinds {

int primitive_count(const Sphere&) { return 1; }

void extend(Extent& extent, const Sphere& s) { extent.add(s.center, {s.radius, s.radius, s.radius}); }

void check(Faults& faults, const Sphere& s) {
  faults.require(is_finite(s.center), "the center must be finite");
  faults.require_radius(s.radius);
  faults.require_orthonormal(s.frame);
}

void pack(const Planes& to, const Sphere& s) { to.put(to.primitive().point(s.center).length(s.radius)); }

bool faces_inward(const Sphere&) { return false; }

std::optional<std::array<double, 9>> surface_frame(const Sphere& s, const UploadFrame&) {
  return nine(s.frame[0], s.frame[1], s.frame[2]);
}

void emit(AreaItems& items, const Sphere& s, Primitives) {
  const double radius = items.frame().scale * s.radius;
  extend(items.extent(), s);
  items.round({items.frame().point(s.center)}, 4 * std::numbers::pi * radius * radius);
  items.number(radius);
  items.axes(s.frame);
}

int first_of_area(const Sphere&, int, bool) { return 0; }

Vec2 uv_rates(const Sphere& s) {
  const double turn = 2 * std::numbers::pi;
  return {1 / (turn * s.radius), 2 / (turn * s.radius)};
}

void move(Sphere& s, const MapVec3& point, const MapVec3&) { s.center = point(s.center); }

void scale(Sphere& s, double factor) { s.radius *= factor; }

Mirrored mirror(Sphere& s, const MapVec3& flip_x) {
  for (Vec3& axis : s.frame) axis = flip_x(axis);
  return Mirrored::alike;
}

std::optional<Bounds<double>> bounds_sphere(const double* p, double) {
  Bounds<double> box{};
  for (std::size_t axis = 0; axis < 3; ++axis) widen(box, axis, p[axis], p[axis], p[3]);
  return box;
}

}  // namespace strahl::kinds
