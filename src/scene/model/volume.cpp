// SPDX-License-Identifier: MIT
#include "scene/model/volume.h"

#include <algorithm>
#include <utility>

namespace strahl {

VolumeGrid grid_of_texels(int height, int depth, Texels texels) {
  VolumeGrid grid;
  grid.height = height;
  grid.depth = depth;
  grid.texels = std::move(texels);
  if (grid.texels.is_grey && grid.texels.format == TexelFormat::real) {
    const double most = *std::max_element(grid.texels.reals.begin(), grid.texels.reals.end());
    grid.largest = {most, most, most};
    return grid;
  }
  const TexelDecoder decoded(grid.texels, {TexelCurve::Kind::linear, 1});
  for (std::size_t n = 0; n < grid.texels.count(); ++n) {
    const auto [r, g, b] = decoded(n);
    grid.largest = {std::max(grid.largest.r, r), std::max(grid.largest.g, g), std::max(grid.largest.b, b)};
  }
  return grid;
}

VolumeGrid grid_of_floats(int width, int height, int depth, int channels, std::vector<float> values) {
  return grid_of_texels(height, depth, repaired_texels(width, height * depth, channels, std::move(values)));
}

}  // namespace strahl
