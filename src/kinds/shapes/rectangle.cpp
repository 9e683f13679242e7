// SPDX-License-Identifier: MIT
// Rectangle: one parallelogram.
#include "kinds/box_around.h"
#include "kinds/rates_of_edges.h"
#include "kinds/shapes.h"

namespace strahl::kinds {

int primitive_count(const Rectangle&) { return 1; }

void extend(Extent& extent, const Rectangle& r) {
  extent.add(r.corner), extent.add(r.corner + r.edge_u), extent.add(r.corner + r.edge_v);
  extent.add(r.corner + r.edge_u + r.edge_v);
}

void check(Faults& faults, const Rectangle& r) {
  faults.require(is_finite(r.corner) && is_finite(r.edge_u) && is_finite(r.edge_v), "the rectangle must be finite");
  faults.require(!is_degenerate(r.edge_u, r.edge_v), "the rectangle's edges must span an area");
}

void pack(const Planes& to, const Rectangle& r) {
  to.parallelogram(r.corner, r.corner + r.edge_u, r.corner + r.edge_u + r.edge_v, r.corner + r.edge_v);
}

bool faces_inward(const Rectangle&) { return false; }

std::optional<std::array<double, 9>> surface_frame(const Rectangle&, const UploadFrame&) { return std::nullopt; }

void emit(AreaItems& items, const Rectangle& r, Primitives) {
  extend(items.extent(), r);
  items.flat(r.corner, r.edge_u, r.edge_v, 1);
}

int first_of_area(const Rectangle&, int, bool) { return 0; }

Vec2 uv_rates(const Rectangle& r) { return rates_of_edges(r.edge_u, r.edge_v); }

void move(Rectangle& r, const MapVec3& point, const MapVec3& vector) {
  r.corner = point(r.corner);
  r.edge_u = vector(r.edge_u);
  r.edge_v = vector(r.edge_v);
}

void scale(Rectangle&, double) {}

Mirrored mirror(Rectangle&, const MapVec3&) { return Mirrored::flipped; }

std::optional<Bounds<double>> bounds_parallelogram(const double* p, double) { return around_corners(p, 4); }

}  // namespace strahl::kinds
