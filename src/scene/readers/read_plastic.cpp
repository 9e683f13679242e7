// SPDX-License-Identifier: MIT
// <bsdf type="plastic"> and <bsdf type="roughplastic">: a diffuse base under a dielectric.
#include "scene/readers/read_material.h"
#include "scene/readers/read_parts.h"
#include "scene/readers/read_texture.h"

namespace strahl {

namespace {

Plastic read_plastic_parts(Properties& properties, SceneBuilder& builder) {
  Plastic plastic;
  plastic.int_ior = read_index_of_refraction(properties, "int_ior", plastic.int_ior);
  plastic.ext_ior = read_index_of_refraction(properties, "ext_ior", plastic.ext_ior);
  plastic.diffuse_reflectance = read_reflectance(properties, builder, "diffuse_reflectance", {0.5, 0.5, 0.5});
  plastic.specular_reflectance = read_reflectance(properties, builder, "specular_reflectance", {1, 1, 1});
  plastic.nonlinear = properties.boolean("nonlinear").value_or(false);
  return plastic;
}

}  // namespace

Material read_plastic(Properties& properties, SceneBuilder& builder) {
  Material material;
  material.bsdf = read_plastic_parts(properties, builder);
  return material;
}

Material read_roughplastic(Properties& properties, SceneBuilder& builder) {
  Material material;
  material.bsdf = RoughPlastic{read_plastic_parts(properties, builder), read_microfacets(properties, builder)};
  return material;
}

}  // namespace strahl
