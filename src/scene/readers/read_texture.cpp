// SPDX-License-Identifier: MIT
// Textures by name, each read once.
#include "scene/readers/read_texture.h"

#include "scene/readers/plugin_table.h"

namespace strahl {

namespace {

const PluginTable<TextureReader>& texture_readers() {
  static const PluginTable<TextureReader> table{
#define TEXTURE(name) {#name, read_##name},
#include "../../../cl/textures/textures.def"
#undef TEXTURE
  };
  return table;
}

int texture_index(const XmlElement& element, TextureReader reader, SceneBuilder& builder) {
  const auto known = builder.texture_indices.find(&element);
  if (known != builder.texture_indices.end()) return known->second;
  Properties properties(element, builder.ids, builder.diagnostics);
  Texture texture = reader(properties);
  properties.report_unknown();
  texture.id = properties.id();
  texture.where = element.where;
  builder.scene.textures.push_back(std::move(texture));
  const int index = static_cast<int>(builder.scene.textures.size()) - 1;
  builder.texture_indices.emplace(&element, index);
  return index;
}

/// -1: no texture that strahl has.
int texture_of(Properties& properties, SceneBuilder& builder, const std::string& name) {
  const XmlElement* texture = properties.peek(name);
  if (texture == nullptr || texture->tag != "texture") return -1;
  const TextureReader* reader = find_plugin(texture_readers(), texture->text("type"));
  if (reader == nullptr) return -1;
  properties.accept({name.c_str()});
  return texture_index(*texture, *reader, builder);
}

}  // namespace

Reflectance read_reflectance(Properties& properties, SceneBuilder& builder, const std::string& name,
                             const Rgb& absent) {
  if (const int texture = texture_of(properties, builder, name); texture >= 0) return {absent, texture};
  return {properties.color(name, ColorUse::reflectance, {0.5, 0.5, 0.5}).value_or(absent)};
}

Varying read_varying(Properties& properties, SceneBuilder& builder, const std::string& name, const Rgb& absent) {
  if (const int texture = texture_of(properties, builder, name); texture >= 0) return {absent, texture};
  return {properties.color(name, ColorUse::value, absent).value_or(absent)};
}

}  // namespace strahl
