// SPDX-License-Identifier: MIT
// The cells along one axis of a grid, and the texels that a place within each of them may read.
#pragma once

#include <array>
#include <vector>

#include "scene/model/volume.h"

namespace strahl {

/// Cells `cell` texels long, the first of which begins at texel first * cell of the cube.
struct CellAxis {
  double cell = 8, first = 0;
  int count = 1;
};

/// Cells over the part `range` of the cube's axis, of `size` texels: 8 texels long, or by powers of two longer, so that
/// there are at most `most`. A box that is turned against the axes takes more than the cube.
[[nodiscard]] CellAxis cells_over(const std::array<double, 2>& range, int size, double most);

/// For each cell the texels that a trilinear mean within it may read, each once.
[[nodiscard]] std::vector<std::vector<int>> texels_of_cells(const CellAxis& axis, int size, TextureWrap wrap);

}  // namespace strahl
