// SPDX-License-Identifier: MIT
// <bsdf type="twosided">: the bsdf inside it, seen from both sides, or one for each side.
#include <fmt/format.h>

#include "scene/readers/read_material.h"

namespace strahl {

Material read_twosided(Properties& properties, SceneBuilder& builder) {
  const std::vector<const XmlElement*> sides = properties.objects("bsdf");
  if (sides.empty()) {
    builder.diagnostics.error(properties.where(), fmt::format("{} needs a <bsdf> inside", properties.title()));
    return {};
  }
  for (std::size_t i = 2; i < sides.size(); ++i)
    builder.diagnostics.error(sides[i]->where, fmt::format("{} has more than two <bsdf>", properties.title()));
  Material material = material_of(*sides.front(), builder);
  if (builder.lobes_inside.transmits(builder.scene, material)) {
    builder.diagnostics.unknown(properties.where(),
                                "twosided has no effect on what lets light through: both of its sides differ already");
    return material;
  }
  material.twosided = true;
  if (sides.size() == 1) return material;
  const int back = material_index(*sides[1], builder);
  if (builder.lobes_inside.transmits(builder.scene, builder.scene.materials[static_cast<std::size_t>(back)]))
    builder.diagnostics.unknown(sides[1]->where,
                                "what lets light through cannot be a back; the front is used for both");
  else
    material.back = back;
  return material;
}

}  // namespace strahl
