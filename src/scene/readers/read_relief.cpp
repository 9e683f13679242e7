// SPDX-License-Identifier: MIT
// <bsdf type="normalmap"> and <bsdf type="bumpmap">: the bsdf inside them, whose normals a texture bends.
#include <fmt/format.h>

#include "kinds/materials.h"
#include "scene/readers/read_material.h"
#include "scene/readers/read_texture.h"

namespace strahl {

namespace {

Material relief_of(Properties& properties, SceneBuilder& builder, Relief relief) {
  const std::vector<const XmlElement*> inside = properties.objects("bsdf");
  if (inside.size() != 1) {
    builder.diagnostics.error(properties.where(), fmt::format("{} needs one <bsdf> inside", properties.title()));
    return {};
  }
  relief.flip_invalid_normals = properties.boolean("flip_invalid_normals").value_or(true);
  relief.use_shadowing_function = properties.boolean("use_shadowing_function").value_or(true);
  relief.nested = material_index(*inside.front(), builder);
  if (is_or_holds<Relief>(builder.scene, relief.nested))
    builder.diagnostics.unknown(inside.front()->where,
                                "normals are bent twice here; shallow light fades by the inner map alone");
  Material material;
  material.bsdf = relief;
  return material;
}

/// The texture inside; null after an error.
const XmlElement* only_texture(Properties& properties) {
  const std::vector<const XmlElement*> inside = properties.objects("texture");
  if (inside.size() == 1) return inside.front();
  properties.diagnostics().error(properties.where(), fmt::format("{} needs one <texture> inside", properties.title()));
  return nullptr;
}

/// The texture within Mitsuba 0.x's `scale`, whose factor `scale` takes; else the texture itself. Null after an error.
const XmlElement* scaled_texture(const XmlElement& texture, SceneBuilder& builder, double& scale) {
  if (texture.text("type") != "scale") return &texture;
  Properties properties(texture, builder.ids, builder.diagnostics);
  const XmlElement* inside = only_texture(properties);
  if (inside == nullptr) return nullptr;
  scale *= properties.number("scale").value_or(1);
  properties.report_unknown();
  return inside;
}

}  // namespace

Material read_normalmap(Properties& properties, SceneBuilder& builder) {
  Relief relief;
  // Written by the upgrade from 0.x.
  if (properties.has_old_rule("takes_any_texture")) {
    if (const XmlElement* normals = only_texture(properties))
      relief.map = read_nested_texture(*normals, builder, TextureUse::value);
    return relief_of(properties, builder, relief);
  }
  if (!properties.has("normalmap"))
    builder.diagnostics.error(properties.where(), fmt::format("{} needs a normalmap", properties.title()));
  relief.map = read_varying(properties, builder, "normalmap", {0.5, 0.5, 1});
  return relief_of(properties, builder, relief);
}

Material read_bumpmap(Properties& properties, SceneBuilder& builder) {
  Relief relief;
  relief.kind = Relief::Kind::heights;
  relief.scale = properties.number("scale").value_or(1);
  const XmlElement* texture = only_texture(properties);
  const XmlElement* heights = texture == nullptr ? nullptr : scaled_texture(*texture, builder, relief.scale);
  if (heights != nullptr) relief.map = read_nested_texture(*heights, builder, TextureUse::height);
  return relief_of(properties, builder, relief);
}

}  // namespace strahl
