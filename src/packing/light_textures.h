// SPDX-License-Identifier: MIT
// Lights whose colour a texture multiplies.
#pragma once

#include "program/features.h"
#include "scene/model/scene.h"

namespace strahl {

struct TexturedColour {
  Rgb colour;    ///< What the kernels multiply the texture with.
  int row = -1;  ///< Of the table of textures; -1: none.
  Rgb mean;      ///< Of both.
};

/// texture: index into Scene::textures; -1: none. Where the program has no use for it, its mean is part of the colour.
[[nodiscard]] TexturedColour textured_colour(const Rgb& colour, int texture, const Scene& scene,
                                             const Features& features);

}  // namespace strahl
