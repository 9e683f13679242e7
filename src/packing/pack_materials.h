// SPDX-License-Identifier: MIT
// A material as the kernels know it.
#pragma once

#include <vector>

#include "kinds/materials.h"
#include "program/features.h"

namespace strahl {

struct PackedMaterial {
  int kind = -1;  ///< Among the program's; -1: it does not know it, and nothing is reflected.
  bool is_twosided = false;
  std::vector<MaterialSlot> slots;  ///< Of a texture that the program does not know, its mean.
};

[[nodiscard]] PackedMaterial packed_material(const Material& material, const Scene& scene, const Features& features);

}  // namespace strahl
