// SPDX-License-Identifier: MIT
#include "packing/light_textures.h"

#include "kinds/textures.h"
#include "packing/packed_scene.h"

namespace strahl {

TexturedColour textured_colour(const Rgb& colour, int texture, const Scene& scene, const Features& features) {
  if (texture < 0) return {colour, -1, colour};
  const kinds::TextureFacts facts = kinds::texture(scene.textures.at(static_cast<std::size_t>(texture)));
  const Rgb mean = kinds::times(colour, facts.mean);
  if (!features.flag("LIGHT_TEXTURE") || !features.has("textures", facts.entry)) return {mean, -1, mean};
  // Never filtered to the pixel's width: with --texture-lod such rows stand behind the others.
  const int behind = features.flag("TEXTURE_LOD") ? checked_offset(scene.textures.size()) : 0;
  return {colour, texture + behind, mean};
}

}  // namespace strahl
