// SPDX-License-Identifier: MIT
#include "kinds/textures.h"

#include <algorithm>
#include <cmath>

#include "kinds/reflectance.h"

namespace strahl::kinds {
namespace {

struct TextureRow {
  TextureFacts operator()(const Checkerboard& board) const {
    const Rgb &a = board.color0, &b = board.color1;
    TextureFacts facts{.entry = "checkerboard",
                       .reals = {a.r, a.g, a.b, b.r, b.g, b.b},
                       .mean = {0.5 * (a.r + b.r), 0.5 * (a.g + b.g), 0.5 * (a.b + b.b)},
                       .faults = {}};
    facts.reals.insert(facts.reals.end(), board.to_uv.begin(), board.to_uv.end());
    if (!is_reflectance(a) || !is_reflectance(b))
      facts.faults.emplace_back("the colours of a texture must lie in [0, 1]");
    if (!std::all_of(board.to_uv.begin(), board.to_uv.end(), [](double x) { return std::isfinite(x); }))
      facts.faults.emplace_back("to_uv must be finite");
    return facts;
  }
};

}  // namespace

TextureFacts texture(const Texture& texture) { return std::visit(TextureRow{}, texture.pattern); }

}  // namespace strahl::kinds
