// SPDX-License-Identifier: MIT
// <bsdf type="diffuse">: Lambert's law.
#include "scene/readers/read_material.h"
#include "scene/readers/read_texture.h"

namespace strahl {

Material read_diffuse(Properties& properties, SceneBuilder& builder) {
  Material material;
  const Reflectance reflectance = read_reflectance(properties, builder, "reflectance", {0.5, 0.5, 0.5});
  material.bsdf = Diffuse{reflectance.color, reflectance.texture};
  return material;
}

}  // namespace strahl
