// SPDX-License-Identifier: MIT
// <shape type="triangle">: p0, p1, p2; the normal is that of the transformed corners, counter-clockwise.
#include "scene/readers/shape_reader.h"

namespace strahl {

Geometry read_geometry(ShapeInput& input, const Triangle&) {
  Properties& properties = input.properties;
  const auto p0 = properties.required_vector("p0"), p1 = properties.required_vector("p1"),
             p2 = properties.required_vector("p2");
  if (!p0 || !p1 || !p2) return Triangle{};
  if (cross(*p1 - *p0, *p2 - *p0) == Vec3{}) {
    input.builder.diagnostics.error(properties.where(), "the triangle's corners lie on a line; its normal is zero");
    return Triangle{};
  }
  const Transform& t = input.world_from_object;
  return Triangle{t.point(*p0), t.point(*p1), t.point(*p2)};
}

}  // namespace strahl
