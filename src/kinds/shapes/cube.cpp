// SPDX-License-Identifier: MIT
// Parallelepiped: six parallelograms.
#include <algorithm>

#include "kinds/rates_of_edges.h"
#include "kinds/shapes.h"

namespace strahl::kinds {

namespace {

Vec2 larger(const Vec2& a, const Vec2& b) { return {std::max(a.x, b.x), std::max(a.y, b.y)}; }

}  // namespace

int primitive_count(const Cube&) { return 6; }

void extend(Extent& extent, const Cube& c) {
  for (unsigned corner = 0; corner < 8; ++corner) {
    Vec3 p = c.corner;
    for (unsigned i = 0; i < 3; ++i)
      if ((corner >> i & 1U) != 0) p = p + c.edge[i];
    extent.add(p);
  }
}

void check(Faults& faults, const Cube& c) {
  const auto& [x, y, z] = c.edge;
  faults.require(is_finite(c.corner) && is_finite(x) && is_finite(y) && is_finite(z), "the cube must be finite");
  const bool has_zero = x == Vec3{} || y == Vec3{} || z == Vec3{};
  faults.require(!has_zero && dot(normalized(x), cross(normalized(y), normalized(z))) != 0,
                 "the cube's edges must span a volume");
}

/// Faces -x, +x, -y, +y, -z, +z of the cube's own axes, normals outward where those are right-handed (faces_inward).
/// Corners are computed once, so that faces share them to the bit.
void pack(const Planes& to, const Cube& cube) {
  std::array<Vec3, 8> corner;
  for (unsigned i = 0; i < 8; ++i) {
    Vec3 p = cube.corner;
    for (unsigned axis = 0; axis < 3; ++axis)
      if ((i >> axis) & 1u) p = p + cube.edge[axis];
    corner[i] = p;
  }
  for (unsigned axis = 0; axis < 3; ++axis) {
    const unsigned u = 1u << ((axis + 1) % 3), v = 1u << ((axis + 2) % 3);
    for (unsigned side = 0; side < 2; ++side) {
      const unsigned base = side << axis;
      const unsigned first = side == 1 ? u : v, second = side == 1 ? v : u;
      to.parallelogram(corner[base], corner[base | first], corner[base | u | v], corner[base | second]);
    }
  }
}

bool faces_inward(const Cube& cube) { return dot(cross(cube.edge[0], cube.edge[1]), cube.edge[2]) < 0; }

std::optional<std::array<double, 9>> surface_frame(const Cube&, const UploadFrame&) { return std::nullopt; }

/// As in packing: outwards where the edges are right-handed.
void emit(AreaItems& items, const Cube& cube, int) {
  extend(items.extent(), cube);
  for (unsigned axis = 0; axis < 3; ++axis) {
    const Vec3 &u = cube.edge.at((axis + 1) % 3), &v = cube.edge.at((axis + 2) % 3);
    items.flat(cube.corner, v, u, 1);
    items.flat(cube.corner + cube.edge.at(axis), u, v, 1);
  }
}

int first_of_area(const Cube&, int) { return 0; }

Vec2 uv_rates(const Cube& c) {
  Vec2 rates;
  for (unsigned i = 0; i < 3; ++i)
    rates = larger(rates, rates_of_edges(c.edge.at((i + 1) % 3), c.edge.at((i + 2) % 3)));
  const double largest = std::max(rates.x, rates.y);
  return {largest, largest};
}

void move(Cube& c, const MapVec3& point, const MapVec3& vector) {
  c.corner = point(c.corner);
  for (Vec3& edge : c.edge) edge = vector(edge);
}

void scale(Cube&, double) {}

Mirrored mirror(Cube&, const MapVec3&) { return Mirrored::alike; }

}  // namespace strahl::kinds
