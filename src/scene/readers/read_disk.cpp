// SPDX-License-Identifier: MIT
// <shape type="disk">: radius 1 in the xy plane of object space, normal +z. Where to_world makes an ellipse of it, it
// becomes a mesh.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kinds/materials.h"
#include "scene/readers/shape_reader.h"

namespace strahl {

namespace {

constexpr int corners_of_ellipse = 256, rings_of_reliefs = 24;

/// Triangles around the centre. Their corners lie as far outside the ellipse as the polygon's area asks for. As on a
/// disk u is the distance from the centre, and v the angle; each triangle has a centre of its own, whose v is its
/// middle. In rings around it, for heights, whose slopes along v take one step of v over the triangle: each ring is
/// within 1/5 of what it is where it lies.
Mesh ellipse(const Transform& t, int rings) {
  constexpr int corners = corners_of_ellipse + 1;  // Of a ring; the last is the first, with v = 1.
  constexpr double step = 2 * std::numbers::pi / corners_of_ellipse;
  const double radius = std::sqrt(step / std::sin(step));
  Mesh mesh;
  const auto put = [&](double r, double turn) {
    const double angle = turn * step;
    mesh.positions.push_back(t.point({r * std::cos(angle), r * std::sin(angle), 0}));
    mesh.uvs.push_back({r, turn / corners_of_ellipse});
  };
  for (int ring = 0; ring <= rings; ++ring)
    for (int i = 0; i < corners; ++i) put(radius * std::exp2(-0.25 * ring), i);
  for (int i = 0; i < corners_of_ellipse; ++i) put(0, i + 0.5);
  for (int i = 0; i < corners_of_ellipse; ++i) {
    for (int ring = 0; ring < rings; ++ring) {
      const int outer = ring * corners + i, inner = outer + corners;
      mesh.triangles.push_back({outer, outer + 1, inner});
      mesh.triangles.push_back({outer + 1, inner + 1, inner});
    }
    const int last = rings * corners + i;
    mesh.triangles.push_back({last, last + 1, (rings + 1) * corners + i});
  }
  return mesh;
}

}  // namespace

Geometry read_geometry(ShapeInput& input, const Disk&) {
  const Transform& t = input.world_from_object;
  // Normals go with the inverse transpose: a mirrored disk keeps facing its +z, unlike axis_u x axis_v.
  if (t.determinant() < 0) input.shape.flip_normals = !input.shape.flip_normals;
  const Vec3 x = t.column(0), y = t.column(1);
  if (!keeps_round(input, std::max(unlike_lengths(x, y), off_right_angle(x, y)))) {
    input.builder.diagnostics.unknown(
        input.properties.where("to_world"),
        fmt::format("to_world makes an ellipse of {}; a polygon of {} corners and the same area takes its place",
                    input.properties.title(), corners_of_ellipse));
    return ellipse(t, is_or_holds<Relief>(input.builder.scene, input.shape.material) ? rings_of_reliefs : 0);
  }
  const Vec3 unit_x = normalized(x);
  const Vec3 normal = normalized(cross(unit_x, y));
  return Disk{t.translation(), x, length(x) * cross(normal, unit_x)};
}

}  // namespace strahl
