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

}  // namespace

Reflectance read_reflectance(Properties& properties, SceneBuilder& builder, const std::string& name,
                             const Rgb& absent) {
  if (const XmlElement* texture = properties.peek(name); texture != nullptr && texture->tag == "texture") {
    if (const TextureReader* reader = find_plugin(texture_readers(), texture->text("type"))) {
      properties.accept({name.c_str()});
      return {absent, texture_index(*texture, *reader, builder)};
    }
  }
  return {properties.color(name, ColorUse::reflectance, {0.5, 0.5, 0.5}).value_or(absent)};
}

}  // namespace strahl
