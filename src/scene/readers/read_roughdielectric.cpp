// SPDX-License-Identifier: MIT
// <bsdf type="roughdielectric">: rough glass.
#include "scene/readers/read_material.h"
#include "scene/readers/read_parts.h"

namespace strahl {

Material read_roughdielectric(Properties& properties, SceneBuilder& builder) {
  Material material;
  material.bsdf = RoughDielectric{read_glass(properties, builder), read_microfacets(properties, builder)};
  return material;
}

}  // namespace strahl
