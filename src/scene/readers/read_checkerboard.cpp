// SPDX-License-Identifier: MIT
// <texture type="checkerboard">. As Mitsuba, to_uv counts in x and y alone.
#include "scene/readers/read_texture.h"

namespace strahl {

Texture read_checkerboard(Properties& properties, SceneBuilder&, ColorUse use) {
  Checkerboard board;
  const Rgb grey{0.5, 0.5, 0.5};
  // As Mitsuba, whose checkerboard takes its colours alike wherever it stands: in a light, too, a spectrum is a weight.
  if (use != ColorUse::reflectance) use = ColorUse::value;
  board.color0 = properties.color("color0", use, grey).value_or(board.color0);
  board.color1 = properties.color("color1", use, grey).value_or(board.color1);
  board.to_uv = read_uv_map(properties);
  Texture texture;
  texture.pattern = board;
  return texture;
}

}  // namespace strahl
