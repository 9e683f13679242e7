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
  std::string entry;          ///< Of cl/textures/textures.def.
  std::vector<double> reals;  ///< Its parameters, as its file in cl/textures says.
  Rgb mean;                   ///< Replaces the texture where it is disabled; of what meshes have, half of its scale.
  const Bitmap* bitmap = nullptr;   ///< Of an image.
  std::string attribute;            ///< Of meshes, that it shows.
  std::vector<std::string> faults;  ///< Descriptions of its faults.
};

[[nodiscard]] TextureFacts texture(const Texture& texture);

/// Of an image: its mean, and its greatest values channel by channel.
[[nodiscard]] Rgb mean_of(const Texels& texels, const TexelCurve& curve);
[[nodiscard]] Rgb brightest_of(const Texels& texels, const TexelCurve& curve);
/// The greatest values of a texture of the scene; of what meshes have, those of all meshes that have it.
[[nodiscard]] Rgb brightest(const Scene& scene, int texture);

[[nodiscard]] inline Rgb times(double factor, const Rgb& c) { return {factor * c.r, factor * c.g, factor * c.b}; }
[[nodiscard]] inline Rgb times(const Rgb& a, const Rgb& b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }

}  // namespace strahl::kinds
