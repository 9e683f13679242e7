// SPDX-License-Identifier: MIT
// <shape type="plane">, infinite: point + normal; Hesse normal + d (normal . x = d); or parametric point + u, v.
#include <fmt/format.h>

#include "scene/model/build.h"
#include "scene/readers/shape_reader.h"

namespace strahl {

namespace {

Plane read_parametric(Properties& properties) {
  const Vec3 point = properties.vector("point").value_or(Vec3{});
  const std::optional<Vec3> u = properties.required_vector("u"), v = properties.required_vector("v");
  const Vec3 normal = u && v ? cross(*u, *v) : Vec3{0, 1, 0};
  if (normal != Vec3{}) return {point, normal, u.value_or(Vec3{1, 0, 0}), v.value_or(Vec3{0, 0, -1})};
  properties.diagnostics().error(properties.where("u"), "u and v are parallel or zero; they must span the plane");
  return {};
}

Plane read_normal_form(Properties& properties) {
  const Vec3 normal = properties.vector("normal").value_or(Vec3{0, 1, 0});
  if (normal == Vec3{}) {
    properties.diagnostics().error(properties.where("normal"), "the normal is zero; it must have a direction");
    return {};
  }
  const std::optional<double> d = properties.number("d");
  const Vec3 point = d ? (*d / length(normal)) * normalized(normal) : properties.vector("point").value_or(Vec3{});
  return plane_through(point, normal);
}

void report_conflict(Properties& properties) {
  const bool spanned = properties.has("u") || properties.has("v");
  const char* second = spanned && properties.has("normal")                           ? "normal"
                       : properties.has("d") && (properties.has("point") || spanned) ? "d"
                                                                                     : nullptr;
  if (second == nullptr) return;
  properties.accept({"point", "d", "normal"});
  properties.diagnostics().error(
      properties.where(second),
      fmt::format("\"{}\" says the plane a second time; give point + normal, normal + d, or point + u + v", second));
}

}  // namespace

Geometry read_geometry(ShapeInput& input, const Plane&) {
  Properties& properties = input.properties;
  report_conflict(properties);
  const bool spanned = properties.has("u") || properties.has("v");
  Plane plane = spanned ? read_parametric(properties) : read_normal_form(properties);
  const Transform& t = input.world_from_object;
  return Plane{t.point(plane.point), t.normal(plane.normal), t.vector(plane.u), t.vector(plane.v)};
}

}  // namespace strahl
