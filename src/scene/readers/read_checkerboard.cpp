// SPDX-License-Identifier: MIT
// <texture type="checkerboard">. As Mitsuba, to_uv counts in x and y alone.
#include "scene/readers/read_texture.h"

namespace strahl {

Texture read_checkerboard(Properties& properties) {
  Checkerboard board;
  const Rgb grey{0.5, 0.5, 0.5};
  board.color0 = properties.color("color0", ColorUse::reflectance, grey).value_or(board.color0);
  board.color1 = properties.color("color1", ColorUse::reflectance, grey).value_or(board.color1);
  if (const auto t = properties.transform("to_uv"))
    board.to_uv = {t->m[0][0], t->m[0][1], t->m[0][3], t->m[1][0], t->m[1][1], t->m[1][3]};
  Texture texture;
  texture.pattern = board;
  return texture;
}

}  // namespace strahl
