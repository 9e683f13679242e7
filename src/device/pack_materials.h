// SPDX-License-Identifier: MIT
// A material as the kernels know it.
#pragma once

#include "device/features.h"

namespace strahl {

struct PackedMaterial {
  int kind = -1;     ///< Among the program's; -1: it does not know it, and nothing is reflected.
  int texture = -1;  ///< Index into Scene::textures that the reflectance comes from; -1: none.
  Rgb reflectance;   ///< Of a texture that the program does not know, its mean.
};

[[nodiscard]] PackedMaterial packed_material(const Material& material, const Scene& scene, const Features& features);

}  // namespace strahl
