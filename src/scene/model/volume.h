// SPDX-License-Identifier: MIT
// Values that vary in space.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "image/texels.h"
#include "scene/model/vec.h"

namespace strahl {

enum class TextureFilter { bilinear, nearest };
enum class TextureWrap { repeat, mirror, clamp };

/// Texels of a box, cell-centred: width along x, height along y, depth along z. Row (y, z) of x is row z * height + y
/// of the image.
struct VolumeGrid {
  int height = 0, depth = 0;
  Texels texels;
  Rgb largest;                       ///< Of all texels, by channel.
  Vec3 low{0, 0, 0}, high{1, 1, 1};  ///< The box that its file states.
};

/// texels: height * depth rows.
[[nodiscard]] VolumeGrid grid_of_texels(int height, int depth, Texels texels);
/// channels: 1 or 3 a texel, x first, then y, then z; what is negative, infinite or no number is repaired as of images.
[[nodiscard]] VolumeGrid grid_of_floats(int width, int height, int depth, int channels, std::vector<float> values);

/// A value everywhere, or a grid over the unit cube, placed in the world.
struct Volume {
  Volume(const Rgb& everywhere) : value(everywhere) {}  // NOLINT(google-explicit-constructor): a colour is a volume

  Rgb value;                               ///< Of a grid: multiplies its texels.
  std::shared_ptr<const VolumeGrid> grid;  ///< Null: none.
  Transform world_from_cube;
  TextureFilter filter = TextureFilter::bilinear;  ///< In all three axes.
  TextureWrap wrap = TextureWrap::clamp;           ///< Beyond the cube.

  /// The largest value anywhere, by channel.
  [[nodiscard]] Rgb largest() const {
    if (!grid) return value;
    return {value.r * grid->largest.r, value.g * grid->largest.g, value.b * grid->largest.b};
  }
};

}  // namespace strahl
