// SPDX-License-Identifier: MIT
// The properties of each kind of texture that the host needs, one row each (textures.cpp). A kind of Texture::pattern
// without a row does not compile.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "scene/model/scene.h"

namespace strahl::kinds {

struct TextureFacts {
  std::string entry;                ///< Of cl/textures/textures.def.
  std::vector<double> reals;        ///< Its parameters, as its file in cl/textures says.
  Rgb mean;                         ///< Replaces the texture where it is disabled.
  const Bitmap* bitmap = nullptr;   ///< Of an image.
  std::vector<std::string> faults;  ///< Descriptions of its faults.
};

[[nodiscard]] TextureFacts texture(const Texture& texture);

/// The mean of an image.
[[nodiscard]] Rgb mean_of(const Texels& texels, const TexelCurve& curve);

}  // namespace strahl::kinds
