// SPDX-License-Identifier: MIT
// A material as the kernels know it.
#pragma once

#include <vector>

#include "kinds/materials.h"
#include "packing/entry_numbers.h"
#include "program/features.h"

namespace strahl {

struct PackedMaterial {
  int kind = -1;  ///< Among the program's; -1: it does not know it, and nothing is reflected.
  int back = -1;  ///< Its MATERIAL_BACK.
  bool has_along = false;
  int indices = 0;              ///< layout::INDICES_...
  int first = -1, second = -1;  ///< Its MATERIAL_FIRST and MATERIAL_SECOND.
  MaterialSlot opacity{"opacity", {1, 1, 1}};
  std::vector<MaterialSlot> slots;  ///< Of a texture that the program does not know, its mean.
};

/// Of scene.materials[row].
[[nodiscard]] PackedMaterial packed_material(std::size_t row, const Scene& scene, const Features& features,
                                             EntryNumbers& numbers);

}  // namespace strahl
