// SPDX-License-Identifier: MIT
// <bsdf type="phong"> of Mitsuba 0.x: a highlight over a diffuse base.
#include "scene/readers/read_material.h"
#include "scene/readers/read_texture.h"

namespace strahl {

Material read_phong(Properties& properties, SceneBuilder& builder) {
  Phong bsdf;
  bsdf.diffuse_reflectance =
      read_reflectance(properties, builder, "diffuse_reflectance", bsdf.diffuse_reflectance.color);
  bsdf.specular_reflectance =
      read_reflectance(properties, builder, "specular_reflectance", bsdf.specular_reflectance.color);
  bsdf.exponent = read_number(properties, builder, "exponent", bsdf.exponent.color, TextureUse::value);
  Material material;
  material.bsdf = bsdf;
  return material;
}

}  // namespace strahl
