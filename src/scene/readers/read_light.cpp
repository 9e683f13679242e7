// SPDX-License-Identifier: MIT
// Emitters outside shapes: point, directional, constant.
#include <fmt/format.h>

#include <algorithm>

#include "kinds/lights.h"
#include "scene/readers/plugin_table.h"
#include "scene/readers/readers.h"
#include "scene/xml/properties.h"

namespace strahl {

namespace {

using Emitter = decltype(Light::emitter);
using LightReader = Emitter (*)(Properties&);

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

Emitter read_point(Properties& properties) {
  const Vec3 position = properties.vector("position").value_or(Vec3{});
  const std::optional<Transform> to_world = transform_instead_of("position", properties);
  return PointLight{to_world ? to_world->translation() : position, emission(properties, "intensity")};
}

Emitter read_directional(Properties& properties) {
  const Vec3 direction = properties.vector("direction").value_or(Vec3{0, 0, 1});
  const std::optional<Transform> to_world = transform_instead_of("direction", properties);
  if (direction == Vec3{})
    properties.diagnostics().error(properties.where("direction"), "the direction is zero; light must travel somewhere");
  return DirectionalLight{to_world ? to_world->column(2) : direction, emission(properties, "irradiance")};
}

Emitter read_constant(Properties& properties) { return ConstantLight{emission(properties, "radiance")}; }

const PluginTable<LightReader>& light_readers() {
  static const PluginTable<LightReader> table{
      {"point", read_point}, {"directional", read_directional}, {"constant", read_constant}};
  return table;
}

bool has_background(const Scene& scene) {
  return std::any_of(scene.lights.begin(), scene.lights.end(),
                     [](const Light& light) { return kinds::light(light).is_background; });
}

}  // namespace

void read_light(const XmlElement& element, SceneBuilder& builder) {
  Properties properties(element, builder.ids, builder.diagnostics);
  const std::string_view type = properties.type();
  if (type == "area") {
    if (properties.id().empty())
      builder.diagnostics.unknown(element.where, "an area emitter belongs inside a <shape>; it is left out");
    return;
  }
  const LightReader* reader = find_plugin(light_readers(), type);
  if (reader == nullptr) {
    builder.diagnostics.unknown(element.where, fmt::format("unknown emitter \"{}\"{}; it is left out", type,
                                                           did_you_mean_plugin(light_readers(), type)));
    return;
  }
  Light light{properties.id(), (*reader)(properties), element.where};
  if (kinds::light(light).is_background && has_background(builder.scene))
    builder.diagnostics.error(element.where, "a scene has one constant emitter at most");
  properties.accept({"sampling_weight"});
  properties.report_unknown();
  builder.scene.lights.push_back(light);
}

}  // namespace strahl
