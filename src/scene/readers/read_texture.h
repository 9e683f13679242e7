// SPDX-License-Identifier: MIT
// <texture> elements: a reader for each entry of the kernels' list, which the linker names where it is missing.
#pragma once

#include "scene/xml/properties.h"
#include "scene/xml/scene_builder.h"

namespace strahl {

/// Fills `pattern`; the rest is done by read_reflectance() and read_varying().
using TextureReader = Texture (*)(Properties&);

#define TEXTURE(name) Texture read_##name(Properties& properties);
#include "../../../cl/textures/textures.def"
#undef TEXTURE

/// The parameter `name`, or `absent`. A texture that strahl does not have is replaced with a warning.
[[nodiscard]] Reflectance read_reflectance(Properties& properties, SceneBuilder& builder, const std::string& name,
                                           const Rgb& absent);

/// As read_reflectance, of values that are no shares of light.
[[nodiscard]] Varying read_varying(Properties& properties, SceneBuilder& builder, const std::string& name,
                                   const Rgb& absent);

}  // namespace strahl
