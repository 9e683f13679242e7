// SPDX-License-Identifier: MIT
// <shape type="disk">: radius 1 in the xy plane of object space, normal +z. Where to_world makes an ellipse of it, it
// becomes a mesh.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "scene/readers/shape_reader.h"

namespace strahl {

namespace {

constexpr int corners_of_ellipse = 256;

/// Triangles around the centre. Their corners lie as far outside the ellipse as the polygon's area asks for. As on a
/// disk u is the distance from the centre, and v the angle; each triangle has a centre of its own, whose v is its
/// middle.
Mesh ellipse(const Transform& t) {
  constexpr double step = 2 * std::numbers::pi / corners_of_ellipse;
  const double radius = std::sqrt(step / std::sin(step));
  Mesh mesh;
  const auto put = [&](double r, double turn) {
    const double angle = turn * step;
    mesh.positions.push_back(t.point({r * std::cos(angle), r * std::sin(angle), 0}));
    mesh.uvs.push_back({r, turn / corners_of_ellipse});
  };
  for (int i = 0; i <= corners_of_ellipse; ++i) put(radius, i);
  for (int i = 0; i < corners_of_ellipse; ++i) {
    put(0, i + 0.5);
    mesh.triangles.push_back({i, i + 1, corners_of_ellipse + 1 + i});
  }
  return mesh;
}

}  // namespace

Geometry read_geometry(ShapeInput& input, const Disk&) {
  const Transform& t = input.world_from_object;
  // Normals go with the inverse transpose: a mirrored disk keeps facing its +z, unlike axis_u x axis_v.
  if (t.determinant() < 0) input.shape.flip_normals = !input.shape.flip_normals;
  const Vec3 x = t.column(0), y = t.column(1);
  if (!are_equally_long(x, y) || !are_perpendicular(x, y)) {
    input.builder.diagnostics.unknown(
        input.properties.where("to_world"),
        fmt::format("to_world makes an ellipse of {}; a polygon of {} corners and the same area takes its place",
                    input.properties.title(), corners_of_ellipse));
    return ellipse(t);
  }
  const Vec3 unit_x = normalized(x);
  const Vec3 normal = normalized(cross(unit_x, y));
  return Disk{t.translation(), x, length(x) * cross(normal, unit_x)};
}

}  // namespace strahl
