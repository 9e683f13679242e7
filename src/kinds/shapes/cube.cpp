// SPDX-License-Identifier: MIT
// Parallelepiped: six parallelograms.
#include <algorithm>
#include <array>
#include <limits>

#include "kinds/rates_of_edges.h"
#include "kinds/shapes.h"

namespace strahl::kinds {

namespace {

/// Along which axes u and v of a face run, and whether downwards: as of the mesh that is Mitsuba's cube.
struct FaceAxes {
  unsigned u;
  bool is_u_down;
  unsigned v;
  bool is_v_down;
};

/// Faces -x, +x, -y, +y, -z, +z. u x v points inwards on all.
constexpr std::array<FaceAxes, 6> face_axes{{{1, false, 2, false},
                                             {1, false, 2, true},
                                             {2, false, 0, false},
                                             {0, true, 2, true},
                                             {1, true, 0, false},
                                             {1, false, 0, false}}};

/// The corner where u and v of a face are 0: a bit an axis.
unsigned first_corner(unsigned face) {
  const FaceAxes& axes = face_axes.at(face);
  return (face % 2) << (face / 2) | (axes.is_u_down ? 1U << axes.u : 0U) | (axes.is_v_down ? 1U << axes.v : 0U);
}

Vec3 corner_of(const Cube& cube, unsigned bits) {
  Vec3 p = cube.corner;
  for (unsigned axis = 0; axis < 3; ++axis)
    if ((bits >> axis & 1U) != 0) p = p + cube.edge.at(axis);
  return p;
}

}  // namespace

int primitive_count(const Cube&) { return 6; }

void extend(Extent& extent, const Cube& c) {
  for (unsigned corner = 0; corner < 8; ++corner) extent.add(corner_of(c, corner));
}

void check(Faults& faults, const Cube& c) {
  const auto& [x, y, z] = c.edge;
  faults.require(is_finite(c.corner) && is_finite(x) && is_finite(y) && is_finite(z), "the cube must be finite");
  const bool has_zero = x == Vec3{} || y == Vec3{} || z == Vec3{};
  faults.require(!has_zero && dot(normalized(x), cross(normalized(y), normalized(z))) != 0,
                 "the cube's edges must span a volume");
}

/// Faces -x, +x, -y, +y, -z, +z of the cube's own axes. Corners are computed once, so that faces share them to the bit.
void pack(const Planes& to, const Cube& cube) {
  std::array<Vec3, 8> corner;
  for (unsigned i = 0; i < 8; ++i) corner.at(i) = corner_of(cube, i);
  for (unsigned face = 0; face < 6; ++face) {
    const unsigned base = first_corner(face), u = 1U << face_axes.at(face).u, v = 1U << face_axes.at(face).v;
    to.parallelogram(corner.at(base), corner.at(base ^ u), corner.at(base ^ u ^ v), corner.at(base ^ v));
  }
}

bool faces_inward(const Cube& cube) { return dot(cross(cube.edge[0], cube.edge[1]), cube.edge[2]) > 0; }

std::optional<std::array<double, 9>> surface_frame(const Cube&, const UploadFrame&) { return std::nullopt; }

/// As in packing.
void emit(AreaItems& items, const Cube& cube, Primitives) {
  extend(items.extent(), cube);
  for (unsigned face = 0; face < 6; ++face) {
    const auto& [u, is_u_down, v, is_v_down] = face_axes.at(face);
    items.flat(corner_of(cube, first_corner(face)), (is_u_down ? -1.0 : 1.0) * cube.edge.at(u),
               (is_v_down ? -1.0 : 1.0) * cube.edge.at(v), 1);
  }
}

int first_of_area(const Cube&, int, bool) { return 0; }

/// Each edge is one of u on some face and one of v on another.
Vec2 uv_rates(const Cube& c) {
  double least = std::numeric_limits<double>::infinity();
  for (unsigned i = 0; i < 3; ++i) {
    const Vec2 rates = rates_of_edges(c.edge.at((i + 1) % 3), c.edge.at((i + 2) % 3));
    least = std::min({least, rates.x, rates.y});
  }
  return {least, least};
}

void move(Cube& c, const MapVec3& point, const MapVec3& vector) {
  c.corner = point(c.corner);
  for (Vec3& edge : c.edge) edge = vector(edge);
}

void scale(Cube&, double) {}

Mirrored mirror(Cube&, const MapVec3&) { return Mirrored::alike; }

}  // namespace strahl::kinds
