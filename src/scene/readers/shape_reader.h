// SPDX-License-Identifier: MIT
// What the reader of a shape's geometry gets and gives; one read_<shape>.cpp each.
#pragma once

#include <optional>

#include "scene/model/scene.h"
#include "scene/xml/properties.h"
#include "scene/xml/scene_builder.h"

namespace strahl {

/// A <bsdf> of the shape for the faces that have this material in its file.
struct NamedMaterial {
  std::string name;
  int material;  ///< Index into Scene::materials.
  SourceLocation where;
};

struct ShapeInput {
  Properties& properties;
  Transform world_from_object;
  Shape& shape;               ///< Material, radiance and flip_normals are set already; a reader may change them.
  bool has_material = false;  ///< The shape has a <bsdf> of its own.
  SceneBuilder& builder;
  std::vector<NamedMaterial> named_materials{};
  bool is_left_out = false;  ///< Set by a reader that has warned that nothing can be seen of the shape.
};

/// What every shape of Mitsuba 3 takes for its gradients; no picture shows it.
inline constexpr const char* silhouette_weight = "silhouette_sampling_weight";

/// World-frame geometry, for the types that shapes.def names in the row of S. After an error (in the diagnostics) any
/// geometry: the scene is not used then. The linker names a row without its reader.
#define SHAPE_KIND(S, kind, area, types) Geometry read_geometry(ShapeInput& input, const S&);
#include "kinds/shapes.def"
#undef SHAPE_KIND

/// One <shape>: geometry, material, emitter; appended to `shapes`. A type that is unknown is reported and left out.
void read_shape(const XmlElement& element, SceneBuilder& builder, std::vector<Shape>& shapes);

/// <shape type="shapegroup"> and <shape type="instance">, which are no shapes of the scene themselves.
[[nodiscard]] bool is_group(const XmlElement& shape);
[[nodiscard]] bool is_instance(const XmlElement& shape);
/// Index into Scene::groups; each is read once. None where all its shapes were left out, which is then said.
std::optional<int> group_index(const XmlElement& element, SceneBuilder& builder);
/// Appended to builder.scene.
void read_instance(const XmlElement& element, SceneBuilder& builder);

/// Where the parameter "filename" points; it must be a file with that extension. Else none, which is reported.
[[nodiscard]] std::optional<std::string> data_path(ShapeInput& input, std::string_view extension);

/// In the world frame; none where it would not be round there, which is reported.
[[nodiscard]] std::optional<Sphere> placed_sphere(Sphere object, ShapeInput& input);

// ---- what a transform may do to shapes that have a radius ------------------------------------------------------

/// Relative deviation from equal lengths and right angles up to which a transform counts as rotation and uniform
/// scale. Files carry matrices with six decimals: entries are off by 5e-7, sums of three products by less than 1e-5.
constexpr double shape_tolerance = 1e-5;
/// Up to here it does so with a warning: of a small scale six decimals keep few digits.
constexpr double widest_shape_tolerance = 1e-3;

/// The relative deviation from equal lengths.
[[nodiscard]] double unlike_lengths(const Vec3& a, const Vec3& b);
/// The cosine of the angle between them.
[[nodiscard]] double off_right_angle(const Vec3& a, const Vec3& b);
/// Whether to_world, of that deviation, keeps the shape round; a warning where it nearly does.
[[nodiscard]] bool keeps_round(const ShapeInput& input, double deviation);
/// Reports that to_world would make something else of the shape.
void report_distortion(const ShapeInput& input, const char* remedy);

}  // namespace strahl
