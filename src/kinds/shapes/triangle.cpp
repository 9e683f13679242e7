// SPDX-License-Identifier: MIT
// Single triangle; meshes: shapes/mesh.cpp.
#include "kinds/box_around.h"
#include "kinds/rates_of_edges.h"
#include "kinds/shapes.h"

namespace strahl::kinds {

int primitive_count(const Triangle&) { return 1; }

void extend(Extent& extent, const Triangle& t) { extent.add(t.p0), extent.add(t.p1), extent.add(t.p2); }

void check(Faults& faults, const Triangle& t) {
  faults.require(is_finite(t.p0) && is_finite(t.p1) && is_finite(t.p2), "the corners must be finite");
  faults.require(!is_degenerate(t.p1 - t.p0, t.p2 - t.p0), "the triangle's corners lie on a line; its normal is zero");
}

void pack(const Planes& to, const Triangle& t) { to.put(to.primitive().point(t.p0).point(t.p1).point(t.p2)); }

bool faces_inward(const Triangle&) { return false; }

std::optional<std::array<double, 9>> surface_frame(const Triangle&, const UploadFrame&) { return std::nullopt; }

void emit(AreaItems& items, const Triangle& t, Primitives) {
  extend(items.extent(), t);
  items.flat(t.p0, t.p1 - t.p0, t.p2 - t.p0, 0.5);
}

int first_of_area(const Triangle&, int, bool) { return 0; }

Vec2 uv_rates(const Triangle& t) { return rates_of_edges(t.p1 - t.p0, t.p2 - t.p0); }

void move(Triangle& t, const MapVec3& point, const MapVec3&) {
  for (Vec3* p : {&t.p0, &t.p1, &t.p2}) *p = point(*p);
}

void scale(Triangle&, double) {}

Mirrored mirror(Triangle&, const MapVec3&) { return Mirrored::flipped; }

std::optional<Bounds<double>> bounds_triangle(const double* p, double) { return around_corners(p, 3); }

}  // namespace strahl::kinds
