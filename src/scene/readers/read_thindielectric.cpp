// SPDX-License-Identifier: MIT
// <bsdf type="thindielectric">: a pane of smooth glass as one surface.
#include "scene/readers/read_material.h"
#include "scene/readers/read_parts.h"

namespace strahl {

Material read_thindielectric(Properties& properties, SceneBuilder& builder) {
  Material material;
  material.bsdf = ThinDielectric{read_glass(properties, builder)};
  return material;
}

}  // namespace strahl
