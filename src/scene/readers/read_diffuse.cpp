// SPDX-License-Identifier: MIT
// <bsdf type="diffuse">: Lambert's law.
#include "scene/readers/read_material.h"
#include "scene/readers/read_texture.h"

namespace strahl {

Material read_diffuse(Properties& properties, SceneBuilder& builder) {
  Material material;
  material.bsdf = Diffuse{read_reflectance(properties, builder, "reflectance", {0.5, 0.5, 0.5})};
  return material;
}

}  // namespace strahl
