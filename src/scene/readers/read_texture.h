// SPDX-License-Identifier: MIT
// <texture> elements: a reader for each entry of the kernels' list, which the linker names where it is missing.
#pragma once

#include <array>
#include <memory>

#include "scene/xml/properties.h"
#include "scene/xml/scene_builder.h"

namespace strahl {

/// Fills `pattern`; the rest is done by read_reflectance() and its like. use: of its colours.
using TextureReader = Texture (*)(Properties&, SceneBuilder&, ColorUse use);

#define TEXTURE(name) Texture read_##name(Properties& properties, SceneBuilder& builder, ColorUse use);
#include "../../../cl/textures/textures.def"
#undef TEXTURE

/// A share of the light is at most 1, which images of floats may exceed: a warning says how many texels are cut.
void clamp_to_one(Bitmap& bitmap, const SourceLocation& where, Diagnostics& diagnostics);

/// to_uv, or what uscale, vscale, uvscale, uoffset and voffset of Mitsuba 0.x make of it.
[[nodiscard]] std::array<double, 6> read_uv_map(Properties& properties);

/// The path that the string "filename" names, counted from the scene file; none after an error.
[[nodiscard]] std::optional<std::string> readable_path(Properties& properties, SceneBuilder& builder);

/// The image of the string "filename", read once a scene; null after an error.
[[nodiscard]] std::shared_ptr<const Texels> read_image_file(Properties& properties, SceneBuilder& builder,
                                                            TexelUse use = TexelUse::light);

/// The parameter `name`, or `absent`. A texture that strahl does not have is replaced with a warning.
[[nodiscard]] Reflectance read_reflectance(Properties& properties, SceneBuilder& builder, const std::string& name,
                                           const Rgb& absent);

/// One number in [0, 1], grey: the mean of a colour, as Mitsuba reads one. Of a checkerboard that gives a number the
/// two colours change places, as Mitsuba 3.9's Checkerboard::eval_1 has them; so do those of read_number.
[[nodiscard]] Reflectance read_share(Properties& properties, SceneBuilder& builder, const std::string& name,
                                     double absent);

/// A <texture> that has no name of its own; 0.5 where strahl does not have it, with a warning. use: `value` or
/// `height`.
[[nodiscard]] Varying read_nested_texture(const XmlElement& element, SceneBuilder& builder, TextureUse use);

/// Light: a colour, or a texture that multiplies it.
struct Emission {
  Rgb color{1, 1, 1};
  int texture = -1;  ///< Index into Scene::textures; -1: none.
};

/// The parameter `name`, else white.
[[nodiscard]] Emission read_emission(Properties& properties, SceneBuilder& builder, const std::string& name);

/// As read_reflectance, of values that are no shares of light.
[[nodiscard]] Varying read_varying(Properties& properties, SceneBuilder& builder, const std::string& name,
                                   const Rgb& absent);

/// The same of one number: the mean of a colour. use: `number` or `quantity`, whether those of a texture lie in [0, 1];
/// `value` for materials of Mitsuba 0.x, in which a checkerboard's colours stay where they are.
[[nodiscard]] Varying read_number(Properties& properties, SceneBuilder& builder, const std::string& name,
                                  const Rgb& absent, TextureUse use);

}  // namespace strahl
