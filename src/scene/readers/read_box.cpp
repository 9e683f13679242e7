// SPDX-License-Identifier: MIT
// <shape type="box">: the axis-aligned box [min, max]; to_world may move, scale, mirror and turn by right angles.
#include <algorithm>

#include "scene/readers/shape_reader.h"

namespace strahl {

namespace {

/// Along a coordinate axis, within shape_tolerance.
bool is_axis_aligned(const Vec3& v) {
  const Vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  return std::count_if(std::begin(axes), std::end(axes),
                       [&](const Vec3& a) { return off_right_angle(v, a) <= shape_tolerance; }) == 2;
}

}  // namespace

Geometry read_geometry(ShapeInput& input, const Box&) {
  Properties& properties = input.properties;
  const std::optional<Vec3> min = properties.required_vector("min"), max = properties.required_vector("max");
  if (!min || !max) return Box{};
  if (min->x > max->x || min->y > max->y || min->z > max->z) {
    input.builder.diagnostics.error(properties.where("max"), "max is less than min; swap them where they are reversed");
    return Box{};
  }
  const Transform& t = input.world_from_object;
  if (!is_axis_aligned(t.column(0)) || !is_axis_aligned(t.column(1)) || !is_axis_aligned(t.column(2))) {
    report_distortion(input, "a box stays parallel to the axes; use <shape type=\"cube\"> for a turned one");
    return Box{};
  }
  const Vec3 a = t.point(*min), b = t.point(*max);
  return Box{{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
             {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}};
}

}  // namespace strahl
