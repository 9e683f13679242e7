// SPDX-License-Identifier: MIT
// Images in a scene's buffers: each once, however many textures show it, and each table of codes once.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <tuple>
#include <utility>

#include "image/texels.h"
#include "packing/cl_layout.h"
#include "packing/packed_scene.h"

namespace strahl {

template <typename Real>
class PackedImages {
 public:
  explicit PackedImages(PackedScene<Real>& packed) : packed_(packed) {}

  /// The offset of the image's row (cl/scene/layout.h, IMAGE_...), appended where it is new. texels: outlives this.
  int row(const Texels& texels, const TexelCurve& curve);

  /// Of the image, and of the same in halves of its size down to one texel: rows one after the other.
  struct Levels {
    int row = 0, count = 1;
  };
  Levels levels(const Texels& texels, const TexelCurve& curve);

 private:
  std::array<std::int32_t, layout::IMAGE_INTS> put(const Texels& texels, const TexelCurve& curve);

  using Curve = std::tuple<TexelFormat, TexelCurve::Kind, double>;

  PackedScene<Real>& packed_;
  std::map<const Texels*, int> texels_;
  std::map<Curve, int> tables_;
  std::map<std::pair<const Texels*, int>, int> rows_;       ///< By texels and table.
  std::map<std::pair<const Texels*, int>, Levels> levels_;  ///< Likewise.
  std::deque<Texels> reduced_;                              ///< Kept: the maps know images by their address.
};

}  // namespace strahl
