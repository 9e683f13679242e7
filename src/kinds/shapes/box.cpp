// SPDX-License-Identifier: MIT
// Axis-aligned box.
#include <algorithm>

#include "kinds/shapes.h"

namespace strahl::kinds {

int primitive_count(const Box&) { return 1; }

void extend(Extent& extent, const Box& b) { extent.add(b.min), extent.add(b.max); }

void check(Faults& faults, const Box& b) {
  faults.require(is_finite(b.min) && is_finite(b.max), "the box must be finite");
  faults.require(b.min.x <= b.max.x && b.min.y <= b.max.y && b.min.z <= b.max.z, "min must not be greater than max");
}

void pack(const Planes& to, const Box& b) {
  const Vec3 lo = to.frame.point(b.min), hi = to.frame.point(b.max);
  to.put(to.primitive().number(lo.x).number(hi.x).number(lo.y).number(hi.y).number(lo.z).number(hi.z));
}

bool faces_inward(const Box&) { return false; }

std::optional<std::array<double, 9>> surface_frame(const Box&, const UploadFrame&) { return std::nullopt; }

void emit(AreaItems& items, const Box& b, Primitives primitives) {
  const Vec3 size = b.max - b.min;
  // A cube's faces look outwards where its edges are left-handed.
  emit(items, Cube{b.min, {Vec3{0, size.y, 0}, Vec3{size.x, 0, 0}, Vec3{0, 0, size.z}}}, primitives);
  items.unmap();  // As of hits.
}

int first_of_area(const Box&, int, bool) { return -1; }

Vec2 uv_rates(const Box&) { return {}; }

void move(Box& b, const MapVec3& point, const MapVec3&) {
  const Vec3 a = point(b.min), c = point(b.max);
  b.min = {std::min(a.x, c.x), std::min(a.y, c.y), std::min(a.z, c.z)};
  b.max = {std::max(a.x, c.x), std::max(a.y, c.y), std::max(a.z, c.z)};
}

void scale(Box&, double) {}

Mirrored mirror(Box&, const MapVec3&) { return Mirrored::alike; }

std::optional<Bounds<double>> bounds_box(const double* p, double) {
  return Bounds<double>{p[0], p[1], p[2], p[3], p[4], p[5]};
}

}  // namespace strahl::kinds
