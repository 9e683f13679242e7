// SPDX-License-Identifier: MIT
// <bsdf type="mask">: the bsdf inside it, met by a share of rays. <bsdf type="null">: met by none.
#include <fmt/format.h>

#include "kinds/textures.h"
#include "scene/readers/read_material.h"
#include "scene/readers/read_texture.h"

namespace strahl {

namespace {

/// What is inside a mask that is a mask itself: of a blend all of one, since each row of materials has one opacity, and
/// those of rows within each other multiply.
Material of_its_own_row(const Material& mask, SceneBuilder& builder) {
  Blend all;
  all.weight = Reflectance{{0, 0, 0}};
  all.first = all.second = add_material(mask, builder);
  Material material;
  material.bsdf = all;
  return material;
}

/// The material behind the mask of that opacity.
Material masked(Material material, Reflectance opacity, SceneBuilder& builder) {
  // The mask is on both sides, whichever is seen, and a row of its own comes before they are told apart.
  const bool needs_row = material.opacity && (material.opacity->texture >= 0 || opacity.texture >= 0);
  if (needs_row) {
    material = of_its_own_row(material, builder);
  } else if (material.back >= 0) {
    const Material back = masked(builder.scene.materials[static_cast<std::size_t>(material.back)], opacity, builder);
    material.back = add_material(back, builder);
  }
  if (material.opacity) opacity.color = kinds::times(opacity.color, material.opacity->color);
  material.opacity = opacity;
  return material;
}

}  // namespace

Material read_mask(Properties& properties, SceneBuilder& builder) {
  const std::vector<const XmlElement*> inside = properties.objects("bsdf");
  if (inside.size() != 1) {
    builder.diagnostics.error(properties.where(), fmt::format("{} needs one <bsdf> inside", properties.title()));
    return {};
  }
  const Material material = material_of(*inside.front(), builder);
  return masked(material, read_share(properties, builder, "opacity", 0.5), builder);
}

Material null_material() {
  Material material;
  material.bsdf = Diffuse{{{0, 0, 0}}};
  material.opacity = Reflectance{{0, 0, 0}};
  return material;
}

Material read_null(Properties& /*properties*/, SceneBuilder& /*builder*/) { return null_material(); }

}  // namespace strahl
