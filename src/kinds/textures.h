// SPDX-License-Identifier: MIT
// What the host has to know of each kind of texture, one row each (textures.cpp). A kind of Texture::pattern without a
// row does not compile.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "scene/model/scene.h"

namespace strahl::kinds {

struct TextureFacts {
  std::string entry;                ///< Of cl/textures/textures.def.
  std::vector<double> reals;        ///< Its parameters, as its file in cl/textures says.
  Rgb mean;                         ///< What stands for it where it is left out.
  std::vector<std::string> faults;  ///< What is wrong with it, in words.
};

[[nodiscard]] TextureFacts texture(const Texture& texture);

}  // namespace strahl::kinds
