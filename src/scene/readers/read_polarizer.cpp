// SPDX-License-Identifier: MIT
// <bsdf type="polarizer">, "circular" and "retarder": filters for the polarization of light, which strahl does not
// follow. As in Mitsuba's variants without it, they dim the light that goes through, straight on: of unpolarized light
// a polarizer passes half.
#include "kinds/textures.h"
#include "scene/readers/read_material.h"
#include "scene/readers/read_texture.h"

namespace strahl {

namespace {

/// A pane that reflects nothing and passes `share` of its transmittance.
Material filter(Properties& properties, SceneBuilder& builder, double share) {
  properties.accept({"theta", "delta", "polarizing", "left_handed"});
  ThinDielectric pane;
  pane.glass.int_ior = pane.glass.ext_ior = 1;
  Reflectance& passed = pane.glass.transmittance;
  passed = read_reflectance(properties, builder, "transmittance", {1, 1, 1});
  Material material;
  if (passed.texture < 0 || share == 1) {
    passed.color = kinds::times(share, passed.color);
    material.bsdf = pane;
    return material;
  }
  Blend dimmed;  // A texture has no factor of its own.
  dimmed.weight = Reflectance{{share, share, share}};
  material.bsdf = Diffuse{{{0, 0, 0}}};
  dimmed.first = add_material(material, builder);
  material.bsdf = pane;
  dimmed.second = add_material(material, builder);
  material.bsdf = dimmed;
  return material;
}

}  // namespace

Material read_polarizer(Properties& properties, SceneBuilder& builder) { return filter(properties, builder, 0.5); }
Material read_circular(Properties& properties, SceneBuilder& builder) { return filter(properties, builder, 0.5); }
Material read_retarder(Properties& properties, SceneBuilder& builder) { return filter(properties, builder, 1); }

}  // namespace strahl
