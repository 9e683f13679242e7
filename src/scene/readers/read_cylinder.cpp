// SPDX-License-Identifier: MIT
// <shape type="cylinder">: open, around p0 -> p1 in object space; to_world may also stretch along the axis.
#include <algorithm>

#include "scene/model/perpendicular.h"
#include "scene/readers/shape_reader.h"

namespace strahl {

Geometry read_geometry(ShapeInput& input, const Cylinder&) {
  Properties& properties = input.properties;
  const Vec3 p0 = properties.vector("p0").value_or(Vec3{0, 0, 0});
  const Vec3 p1 = properties.vector("p1").value_or(Vec3{0, 0, 1});
  Cylinder cylinder{p0, p1, properties.positive("radius").value_or(1.0), {1, 0, 0}};
  if (p0 == p1) {
    input.builder.diagnostics.error(properties.where(properties.has("p1") ? "p1" : "p0"),
                                    "p0 and p1 are the same point; a cylinder needs an axis");
    return cylinder;
  }
  const Transform& t = input.world_from_object;
  const auto [across_u, across_v] = orthonormal_basis(normalized(p1 - p0));
  const Vec3 u = t.vector(across_u), v = t.vector(across_v), axis = t.vector(p1 - p0);
  const double deviation =
      std::max({unlike_lengths(u, v), off_right_angle(u, v), off_right_angle(axis, u), off_right_angle(axis, v)});
  if (!keeps_round(input, deviation)) {
    report_distortion(input, "a cylinder can be rotated, moved, scaled uniformly and stretched along its axis only");
    return cylinder;
  }
  cylinder.p0 = t.point(p0);
  cylinder.p1 = t.point(p1);
  cylinder.radius *= length(u);
  if (cylinder.p0 == cylinder.p1) return cylinder;  // Which the scene's check reports.
  // Far off the ends are rounded, and their axis is not quite that of to_world.
  cylinder.reference = perpendicular(u, normalized(cylinder.p1 - cylinder.p0));
  return cylinder;
}

}  // namespace strahl
