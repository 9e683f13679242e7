// SPDX-License-Identifier: MIT
// <bsdf type="difftrans"> of Mitsuba 0.x: a diffuse sheet that lets light through.
#include "scene/readers/read_material.h"
#include "scene/readers/read_texture.h"

namespace strahl {

Material read_difftrans(Properties& properties, SceneBuilder& builder) {
  Material material;
  material.bsdf = DiffTrans{read_reflectance(properties, builder, "transmittance", {0.5, 0.5, 0.5})};
  return material;
}

}  // namespace strahl
