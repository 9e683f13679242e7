// SPDX-License-Identifier: MIT
// <shape type="disk">: radius 1 in the xy plane of object space, normal +z; to_world must keep it round.
#include "scene/readers/shape_reader.h"

namespace strahl {

Geometry read_geometry(ShapeInput& input, const Disk&) {
  const Transform& t = input.world_from_object;
  const Vec3 x = t.column(0), y = t.column(1);
  if (!are_equally_long(x, y) || !are_perpendicular(x, y)) {
    report_distortion(input, "x and y must stay perpendicular and be scaled alike");
    return Disk{{}, {1, 0, 0}, {0, 1, 0}};
  }
  // Normals go with the inverse transpose: a mirrored disk keeps facing its +z, unlike axis_u x axis_v.
  if (t.determinant() < 0) input.shape.flip_normals = !input.shape.flip_normals;
  const Vec3 unit_x = normalized(x);
  const Vec3 normal = normalized(cross(unit_x, y));
  return Disk{t.translation(), x, length(x) * cross(normal, unit_x)};
}

}  // namespace strahl
