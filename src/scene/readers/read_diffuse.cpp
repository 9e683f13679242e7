// SPDX-License-Identifier: MIT
// <bsdf type="diffuse">: Lambert's law.
#include "scene/readers/read_material.h"

namespace strahl {

Material read_diffuse(Properties& properties, SceneBuilder&) {
  Material material;
  const Rgb grey{0.5, 0.5, 0.5};
  material.bsdf = Diffuse{properties.color("reflectance", ColorUse::reflectance, grey).value_or(grey)};
  return material;
}

}  // namespace strahl
