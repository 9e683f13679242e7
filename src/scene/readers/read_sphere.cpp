// SPDX-License-Identifier: MIT
// <shape type="sphere">: center and radius in object space; to_world may turn, move, mirror and scale uniformly.
#include <algorithm>

#include "scene/readers/shape_reader.h"

namespace strahl {

std::optional<Sphere> placed_sphere(Sphere sphere, ShapeInput& input) {
  sphere.center = input.world_from_object.point(sphere.center);
  const Vec3 x = input.world_from_object.column(0), y = input.world_from_object.column(1),
             z = input.world_from_object.column(2);
  const double deviation = std::max({unlike_lengths(x, y), unlike_lengths(x, z), off_right_angle(x, y),
                                     off_right_angle(y, z), off_right_angle(z, x)});
  if (!keeps_round(input, deviation)) {
    report_distortion(input, "a sphere can be rotated, moved and scaled uniformly only");
    return std::nullopt;
  }
  sphere.radius *= length(x);
  const Vec3 frame_x = normalized(x);
  const Vec3 normal = normalized(cross(frame_x, y));
  const bool is_mirrored = input.world_from_object.determinant() < 0;
  // As Mitsuba has it, for spheres alone.
  if (is_mirrored) input.shape.flip_normals = !input.shape.flip_normals;
  const double handedness = is_mirrored ? -1 : 1;
  sphere.frame = {frame_x, cross(normal, frame_x), handedness * normal};
  return sphere;
}

Geometry read_geometry(ShapeInput& input, const Sphere&) {
  Sphere sphere;
  sphere.center = input.properties.vector("center").value_or(Vec3{});
  sphere.radius = input.properties.positive("radius").value_or(1.0);
  return placed_sphere(sphere, input).value_or(sphere);
}

}  // namespace strahl
