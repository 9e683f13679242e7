// SPDX-License-Identifier: MIT
// Open cylinder.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinds/box_around.h"
#include "kinds/shapes.h"

namespace strahl::kinds {

int primitive_count(const Cylinder&) { return 1; }

void extend(Extent& extent, const Cylinder& c) {
  const Vec3 axis = normalized(c.p1 - c.p0);
  const auto across = [&](double a) { return c.radius * std::sqrt(std::max(0.0, 1 - a * a)); };
  const Vec3 half{across(axis.x), across(axis.y), across(axis.z)};
  extent.add(c.p0, half), extent.add(c.p1, half);
}

void check(Faults& faults, const Cylinder& c) {
  faults.require(is_finite(c.p0) && is_finite(c.p1), "p0 and p1 must be finite");
  faults.require_radius(c.radius);
  faults.require(c.p0 != c.p1, "p0 and p1 must differ");
  faults.require(is_unit(c.reference) && (c.p0 == c.p1 || is_zero(dot(c.reference, normalized(c.p1 - c.p0)))),
                 "the reference must be a unit vector perpendicular to the axis");
}

void pack(const Planes& to, const Cylinder& c) {
  const Vec3 axis = c.p1 - c.p0;
  to.put(to.primitive().point(c.p0).vector(normalized(axis)).length(strahl::length(axis)).length(c.radius));
}

bool faces_inward(const Cylinder&) { return false; }

std::optional<std::array<double, 9>> surface_frame(const Cylinder& c, const UploadFrame&) {
  return nine(c.reference, cross(normalized(c.p1 - c.p0), c.reference), {});
}

void emit(AreaItems& items, const Cylinder& c, Primitives) {
  extend(items.extent(), c);
  const Vec3 axis = items.frame().vector(c.p1 - c.p0), first = items.frame().vector(c.radius * c.reference);
  const Vec3 second = cross(normalized(axis), first);
  items.round({items.frame().point(c.p0), axis, first, second}, 2 * std::numbers::pi * length(first) * length(axis));
}

int first_of_area(const Cylinder&, int, bool shines_inwards) { return shines_inwards ? -1 : 0; }

Vec2 uv_rates(const Cylinder& c) { return {1 / (2 * std::numbers::pi * c.radius), 1 / length(c.p1 - c.p0)}; }

void move(Cylinder& c, const MapVec3& point, const MapVec3&) {
  c.p0 = point(c.p0);
  c.p1 = point(c.p1);
}

void scale(Cylinder& c, double factor) { c.radius *= factor; }

Mirrored mirror(Cylinder& c, const MapVec3& flip_x) {
  c.reference = flip_x(c.reference);
  return Mirrored::alike;
}

/// The axis is a unit vector that was rounded; the ends and the wall are off by that rounding.
std::optional<Bounds<double>> bounds_cylinder(const double* p, double roundoff) {
  Bounds<double> box{};
  const double length = p[6], radius = p[7];
  const double off = 4 * roundoff * (length + radius);
  for (std::size_t i = 0; i < 3; ++i) {
    const double a = p[i], b = a + p[3 + i] * length;
    const double reach = reach_of_circle(radius, p[3 + i], p[3 + (i + 1) % 3], p[3 + (i + 2) % 3]);
    widen(box, i, std::min(a, b), std::max(a, b), reach + off);
  }
  return box;
}

}  // namespace strahl::kinds
