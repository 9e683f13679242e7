// SPDX-License-Identifier: MIT
// <bsdf type="blendbsdf">: two bsdfs, each for a share of the light.
#include <fmt/format.h>

#include "scene/readers/read_material.h"
#include "scene/readers/read_texture.h"

namespace strahl {

Material read_blend(Properties& properties, SceneBuilder& builder) {
  const std::vector<const XmlElement*> inside = properties.objects("bsdf");
  if (inside.size() != 2) {
    builder.diagnostics.error(properties.where(), fmt::format("{} needs two <bsdf> inside", properties.title()));
    return {};
  }
  Blend blend;
  blend.weight = read_share(properties, builder, "weight", 0.5);
  blend.first = material_index(*inside[0], builder);
  blend.second = material_index(*inside[1], builder);
  Material material;
  material.bsdf = blend;
  return material;
}

}  // namespace strahl
