// SPDX-License-Identifier: MIT
// <bsdf type="mask">: the bsdf inside it, met by a share of rays. <bsdf type="null">: met by none.
#include <fmt/format.h>

#include "scene/readers/read_material.h"
#include "scene/readers/read_texture.h"

namespace strahl {

Material read_mask(Properties& properties, SceneBuilder& builder) {
  const std::vector<const XmlElement*> inside = properties.objects("bsdf");
  if (inside.size() != 1) {
    builder.diagnostics.error(properties.where(), fmt::format("{} needs one <bsdf> inside", properties.title()));
    return {};
  }
  Material material = material_of(*inside.front(), builder);
  if (material.opacity) {
    builder.diagnostics.unknown(inside.front()->where,
                                "a mask within a mask is not supported; the inner one is left out");
    material.opacity.reset();
  }
  material.opacity = read_share(properties, builder, "opacity", 0.5);
  return material;
}

Material read_null(Properties& /*properties*/, SceneBuilder& /*builder*/) {
  Material material;
  material.bsdf = Diffuse{{{0, 0, 0}}};
  material.opacity = Reflectance{{0, 0, 0}};
  return material;
}

}  // namespace strahl
