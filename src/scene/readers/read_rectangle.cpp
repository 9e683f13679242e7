// SPDX-License-Identifier: MIT
// <shape type="rectangle">: [-1, 1]^2 in the xy plane of object space, normal +z; any affine to_world.
#include "scene/readers/shape_reader.h"

namespace strahl {

Geometry read_geometry(ShapeInput& input, const Rectangle&) {
  input.properties.accept({"face_normals"});  // A mesh in Mitsuba; flat in either case.
  const Transform& t = input.world_from_object;
  // Normals go with the inverse transpose: a mirrored rectangle keeps facing its +z, unlike edge_u x edge_v.
  if (t.determinant() < 0) input.shape.flip_normals = !input.shape.flip_normals;
  return Rectangle{t.point({-1, -1, 0}), 2.0 * t.column(0), 2.0 * t.column(1)};
}

}  // namespace strahl
