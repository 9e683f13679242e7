// SPDX-License-Identifier: MIT
// Emitters outside shapes: a reader for each entry of the kernels' list, which the compiler names where it is missing.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "kinds/lights.h"
#include "kinds/textures.h"
#include "scene/model/framing.h"
#include "scene/model/transforms.h"
#include "scene/readers/plugin_table.h"
#include "scene/readers/read_parts.h"
#include "scene/readers/read_sky.h"
#include "scene/readers/read_texture.h"
#include "scene/readers/readers.h"
#include "scene/xml/properties.h"

namespace strahl {

namespace {

using Emitter = decltype(Light::emitter);
/// None for what is no light by itself.
using LightReader = std::optional<Emitter> (*)(Properties&, SceneBuilder&);

/// A vector parameter, or what to_world makes of its default; both at once is an error.
std::optional<Transform> transform_instead_of(const std::string& name, Properties& properties) {
  const std::optional<Transform> to_world = properties.transform("to_world");
  if (properties.has("to_world") && properties.has(name))
    properties.diagnostics().error(properties.where("to_world"),
                                   fmt::format("give either \"{}\" or \"to_world\", not both", name));
  return to_world;
}

Rgb emission(Properties& properties, const std::string& name) {
  return properties.color(name, ColorUse::emission, {1, 1, 1}).value_or(Rgb{1, 1, 1});
}

std::optional<Emitter> read_point(Properties& properties, SceneBuilder&) {
  const Vec3 position = properties.vector("position").value_or(Vec3{});
  const std::optional<Transform> to_world = transform_instead_of("position", properties);
  return PointLight{to_world ? to_world->translation() : position, emission(properties, "intensity")};
}

/// Whether a transform turns, moves, mirrors and scales all axes alike, and no more.
bool keeps_angles(const Transform& transform) { return nearest_axes(unscaled_columns(transform)).has_value(); }

/// x and y of a texture: those of to_world, and where it changes angles at right angles to the axis, of its handedness.
std::array<Vec3, 2> axes_of_texture(const Transform& to_world) {
  const Vec3 x = normalized(to_world.column(0)), axis = normalized(to_world.column(2));
  if (keeps_angles(to_world)) return {x, normalized(to_world.column(1))};
  const Vec3 across = normalized(x - dot(x, axis) * axis);
  return {across, (to_world.determinant() < 0 ? -1.0 : 1.0) * cross(axis, across)};
}

std::optional<Emitter> read_spot(Properties& properties, SceneBuilder& builder) {
  SpotLight light;
  const Transform to_world = properties.transform("to_world").value_or(Transform{});
  if (!keeps_angles(to_world))
    properties.diagnostics().warning(properties.where("to_world"),
                                     "to_world changes angles, by which Mitsuba distorts the cone of a spot and its "
                                     "texture; here the cone stays round, and the texture square");
  light.position = to_world.translation();
  light.axis = to_world.column(2);
  light.intensity = emission(properties, "intensity");
  light.cutoff_degrees = properties.number("cutoff_angle").value_or(light.cutoff_degrees);
  light.beam_degrees = properties.number("beam_width").value_or(0.75 * light.cutoff_degrees);
  if (properties.has("texture")) {
    const Emission texture = read_emission(properties, builder, "texture");
    light.intensity = kinds::times(light.intensity, texture.color);
    light.texture = texture.texture;
    const auto [x, y] = axes_of_texture(to_world);
    light.x = x;
    light.y = y;
  }
  return light;
}

/// Its picture is as wide for its height as the texture, but where to_world scales the axes differently. As in Mitsuba
/// 3.9 the light is by the scale of the axis brighter.
std::optional<Emitter> read_projector(Properties& properties, SceneBuilder& builder) {
  ProjectorLight light;
  const Transform to_world = properties.transform("to_world").value_or(Transform{});
  light.position = to_world.translation();
  std::array<double, 3> lengths{};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 column = to_world.column(static_cast<int>(i));
    lengths[i] = length(column);
    light.axes[i] = normalized(column);
  }
  light.axes = nearest_axes(light.axes).value_or(light.axes);
  const Emission irradiance = read_emission(properties, builder, "irradiance");
  const double scale = properties.number("scale").value_or(1) * lengths[2];
  light.irradiance = kinds::times({scale, scale, scale}, irradiance.color);
  light.texture = irradiance.texture;
  double width = 1, height = 1;
  if (light.texture >= 0) {
    const Texture& texture = builder.scene.textures[static_cast<std::size_t>(light.texture)];
    const auto* bitmap = std::get_if<Bitmap>(&texture.pattern);
    if (bitmap != nullptr && bitmap->texels) width = bitmap->texels->width, height = bitmap->texels->height;
  }
  const FieldOfView fov = read_field_of_view(properties);
  const double tangent = tan_half_width(fov.degrees, fov.axis, width, height);
  light.tan_x = tangent * lengths[0] / lengths[2];
  light.tan_y = tangent * height / width * lengths[1] / lengths[2];
  return light;
}

/// As in Mitsuba 3.9 a scale of to_world along z makes the light as much brighter; the length of `direction` does not.
std::optional<Emitter> read_directional(Properties& properties, SceneBuilder&) {
  const Vec3 direction = properties.vector("direction").value_or(Vec3{0, 0, 1});
  const std::optional<Transform> to_world = transform_instead_of("direction", properties);
  if (direction == Vec3{})
    properties.diagnostics().error(properties.where("direction"), "the direction is zero; light must travel somewhere");
  const Rgb irradiance = emission(properties, "irradiance");
  if (!to_world) return DirectionalLight{direction, irradiance};
  const Vec3 axis = to_world->column(2);
  return DirectionalLight{axis, kinds::times(length(axis), irradiance)};
}

std::optional<Emitter> read_collimated(Properties& properties, SceneBuilder&) {
  const Transform to_world = properties.transform("to_world").value_or(Transform{});
  return CollimatedLight{to_world.translation(), to_world.column(2), emission(properties, "power")};
}

std::optional<Emitter> read_constant(Properties& properties, SceneBuilder&) {
  properties.accept({"to_world"});  // Alike from everywhere.
  return ConstantLight{emission(properties, "radiance")};
}

std::optional<Emitter> read_envmap(Properties& properties, SceneBuilder& builder) {
  EnvironmentLight light;
  light.texels = read_image_file(properties, builder);
  const double scale = properties.number("scale").value_or(1);
  light.scale = {scale, scale, scale};
  light.mis_compensation = properties.boolean("mis_compensation").value_or(light.mis_compensation);
  if (const std::optional<Transform> to_world = properties.transform("to_world")) {
    const std::array<Vec3, 3> axes = unscaled_columns(*to_world);
    const std::optional<std::array<Vec3, 3>> nearest = nearest_axes(axes);
    light.axes = nearest.value_or(axes);
    // Lengths count as kept as far as nearest_axes() takes them so.
    if (nearest && !nearest_axes({to_world->column(0), to_world->column(1), to_world->column(2)}))
      properties.diagnostics().warning(properties.where("to_world"),
                                       "to_world scales, by which Mitsuba shows the rows of an envmap at other heights "
                                       "above the horizon; here the scale has no effect");
  }
  return light.texels ? std::optional<Emitter>(light) : std::nullopt;
}

/// Has been read with the shapes that refer to it.
std::optional<Emitter> read_area(Properties& properties, SceneBuilder& builder) {
  if (properties.id().empty())
    properties.diagnostics().unknown(properties.where(), "an area emitter belongs inside a <shape>; it is left out");
  else if (!builder.emitters_of_shapes.contains(&properties.element()))
    properties.diagnostics().unknown(
        properties.where(),
        fmt::format("no <shape> refers to the area emitter \"{}\"; it is left out", properties.id()));
  return std::nullopt;
}

std::optional<Emitter> read_directionalarea(Properties& properties, SceneBuilder& builder) {
  return read_area(properties, builder);
}

const PluginTable<LightReader>& light_readers() {
  static const PluginTable<LightReader> table{
#define LIGHT(name) {#name, read_##name},
#define DELTA_LIGHT LIGHT
#include "../../../cl/lights/lights.def"
#undef DELTA_LIGHT
#undef LIGHT
      {"sky", read_sky}, {"sunsky", read_sunsky}};
  return table;
}

bool has_background(const Scene& scene) {
  return std::any_of(scene.lights.begin(), scene.lights.end(), [](const Light& light) {
    return kinds::light(light).is_background && !kinds::light(light).is_sun;
  });
}

}  // namespace

double read_sampling_weight(Properties& properties) {
  const double weight = properties.number("sampling_weight").value_or(1);
  if (std::isfinite(weight) && weight >= 0) return weight;
  properties.diagnostics().error(properties.where("sampling_weight"),
                                 fmt::format("\"sampling_weight\" must be finite and at least 0, not {}", weight));
  return 1;
}

void read_light(const XmlElement& element, SceneBuilder& builder) {
  Properties properties(element, builder.ids, builder.diagnostics);
  const std::string_view type = properties.type();
  const LightReader* reader = find_plugin(light_readers(), type);
  if (reader == nullptr) {
    builder.diagnostics.unknown(
        element.where, fmt::format("{}; it is left out", not_available("emitter", type, types_of(light_readers()))));
    builder.lost_emitters.emplace_back(type);
    return;
  }
  static_cast<void>(properties.objects("medium"));  // The boundaries of media define what surrounds it.
  const std::optional<Emitter> emitter = (*reader)(properties, builder);
  if (!emitter) return;
  Light light{properties.id(), *emitter, element.where, read_sampling_weight(properties)};
  const bool is_background = kinds::light(light).is_background && !kinds::light(light).is_sun;
  if (is_background && has_background(builder.scene))
    builder.diagnostics.error(element.where, "a scene has one constant, envmap or sky emitter at most");
  properties.report_unknown();
  builder.scene.lights.push_back(light);
}

}  // namespace strahl
