// SPDX-License-Identifier: MIT
// <bsdf type="roughdiffuse"> of Mitsuba 0.x: Oren's and Nayar's diffuse facets.
#include "scene/readers/read_material.h"
#include "scene/readers/read_texture.h"

namespace strahl {

Material read_roughdiffuse(Properties& properties, SceneBuilder& builder) {
  RoughDiffuse bsdf;
  bsdf.reflectance = read_reflectance(properties, builder, "reflectance", bsdf.reflectance.color);
  bsdf.alpha = read_number(properties, builder, "alpha", bsdf.alpha.color, TextureUse::value);
  bsdf.use_fast_approx = properties.boolean("use_fast_approx").value_or(false);
  Material material;
  material.bsdf = bsdf;
  return material;
}

}  // namespace strahl
