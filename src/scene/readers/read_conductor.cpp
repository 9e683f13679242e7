// SPDX-License-Identifier: MIT
// <bsdf type="conductor">: smooth metal.
#include "scene/readers/read_material.h"
#include "scene/readers/read_parts.h"
#include "scene/readers/read_texture.h"

namespace strahl {

Material read_conductor(Properties& properties, SceneBuilder& builder) {
  Material material;
  material.bsdf = Conductor{read_reflectance(properties, builder, "specular_reflectance", {1, 1, 1}),
                            read_metal_index(properties, builder)};
  return material;
}

}  // namespace strahl
