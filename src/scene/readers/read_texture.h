// SPDX-License-Identifier: MIT
// <texture> elements; one reader each, registered in textures.def.
#pragma once

#include "scene/xml/properties.h"
#include "scene/xml/scene_builder.h"

namespace strahl {

/// Fills `pattern`; the rest is done by read_reflectance().
using TextureReader = Texture (*)(Properties&);

#define TEXTURE(type, reader) Texture reader(Properties& properties);
#include "scene/readers/textures.def"
#undef TEXTURE

/// The parameter `name`, or `absent`. A texture that strahl does not have is replaced with a warning.
[[nodiscard]] Reflectance read_reflectance(Properties& properties, SceneBuilder& builder, const std::string& name,
                                           const Rgb& absent);

}  // namespace strahl
