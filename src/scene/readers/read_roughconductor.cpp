// SPDX-License-Identifier: MIT
// <bsdf type="roughconductor">: metal of microfacets.
#include "scene/readers/read_material.h"
#include "scene/readers/read_parts.h"
#include "scene/readers/read_texture.h"

namespace strahl {

Material read_roughconductor(Properties& properties, SceneBuilder& builder) {
  Material material;
  material.bsdf = RoughConductor{read_reflectance(properties, builder, "specular_reflectance", {1, 1, 1}),
                                 read_metal_index(properties, builder), read_microfacets(properties, builder)};
  return material;
}

}  // namespace strahl
