// SPDX-License-Identifier: MIT
// <bsdf type="twosided">: the bsdf inside it, seen from both sides.
#include <fmt/format.h>

#include "kinds/materials.h"
#include "scene/readers/read_material.h"

namespace strahl {

Material read_twosided(Properties& properties, SceneBuilder& builder) {
  const std::vector<const XmlElement*> sides = properties.objects("bsdf");
  if (sides.empty()) {
    builder.diagnostics.error(properties.where(), fmt::format("{} needs a <bsdf> inside", properties.title()));
    return {};
  }
  for (std::size_t i = 1; i < sides.size(); ++i) {
    builder.diagnostics.unknown(sides[i]->where,
                                "a bsdf of its own for the back is not supported yet; the first one is used for both");
  }
  Material material = material_of(*sides.front(), builder);
  if (transmits(material)) {
    builder.diagnostics.unknown(properties.where(),
                                "twosided has no effect on what lets light through: both of its sides differ already");
    return material;
  }
  material.twosided = true;
  return material;
}

}  // namespace strahl
