// SPDX-License-Identifier: MIT
// <bsdf type="dielectric">: smooth glass.
#include "scene/readers/read_material.h"
#include "scene/readers/read_parts.h"
#include "scene/readers/read_texture.h"

namespace strahl {

Dielectric read_glass(Properties& properties, SceneBuilder& builder) {
  Dielectric glass;
  glass.int_ior = read_index_of_refraction(properties, "int_ior", glass.int_ior);
  glass.ext_ior = read_index_of_refraction(properties, "ext_ior", glass.ext_ior);
  glass.reflectance = read_reflectance(properties, builder, "specular_reflectance", {1, 1, 1});
  glass.transmittance = read_reflectance(properties, builder, "specular_transmittance", {1, 1, 1});
  return glass;
}

Material read_dielectric(Properties& properties, SceneBuilder& builder) {
  Material material;
  material.bsdf = read_glass(properties, builder);
  return material;
}

}  // namespace strahl
