// SPDX-License-Identifier: MIT
// <shape type="cube">: [-1, 1]^3 in object space; any affine to_world.
#include "scene/readers/shape_reader.h"

namespace strahl {

Geometry read_geometry(ShapeInput& input, const Cube&) {
  input.properties.accept({"face_normals"});  // A mesh in Mitsuba; flat in either case.
  const Transform& t = input.world_from_object;
  return Cube{t.point({-1, -1, -1}), {2.0 * t.column(0), 2.0 * t.column(1), 2.0 * t.column(2)}};
}

}  // namespace strahl
