// SPDX-License-Identifier: MIT
#include "kinds/textures.h"

#include <algorithm>
#include <cmath>

#include "kinds/reflectance.h"

namespace strahl::kinds {
namespace {

bool is_finite_map(const std::array<double, 6>& to_uv) {
  return std::all_of(to_uv.begin(), to_uv.end(), [](double x) { return std::isfinite(x); });
}

struct TextureRow {
  TextureFacts operator()(const Checkerboard& board) const {
    const Rgb &a = board.color0, &b = board.color1;
    TextureFacts facts{.entry = "checkerboard",
                       .reals = {a.r, a.g, a.b, b.r, b.g, b.b},
                       .mean = {0.5 * (a.r + b.r), 0.5 * (a.g + b.g), 0.5 * (a.b + b.b)},
                       .bitmap = nullptr,
                       .faults = {}};
    facts.reals.insert(facts.reals.end(), board.to_uv.begin(), board.to_uv.end());
    if (!is_reflectance(a) || !is_reflectance(b))
      facts.faults.emplace_back("the colours of a texture must lie in [0, 1]");
    if (!is_finite_map(board.to_uv)) facts.faults.emplace_back("to_uv must be finite");
    return facts;
  }
  TextureFacts operator()(const Bitmap& bitmap) const {
    TextureFacts facts{
        .entry = "bitmap",
        .reals = {bitmap.to_uv.begin(), bitmap.to_uv.end()},
        .mean = {bitmap.scale.r * bitmap.mean.r, bitmap.scale.g * bitmap.mean.g, bitmap.scale.b * bitmap.mean.b},
        .bitmap = &bitmap,
        .faults = {}};
    facts.reals.insert(facts.reals.end(), {bitmap.scale.r, bitmap.scale.g, bitmap.scale.b});
    if (!is_reflectance(bitmap.scale)) facts.faults.emplace_back("the scale of a bitmap must lie in [0, 1]");
    if (!bitmap.texels || bitmap.texels->count() == 0) facts.faults.emplace_back("a bitmap needs an image");
    if (!is_finite_map(bitmap.to_uv)) facts.faults.emplace_back("to_uv must be finite");
    return facts;
  }
};

}  // namespace

TextureFacts texture(const Texture& texture) { return std::visit(TextureRow{}, texture.pattern); }

Rgb mean_of(const Texels& texels, const TexelCurve& curve) {
  const TexelDecoder decoded(texels, curve);
  std::array<double, 3> sum{};
  for (std::size_t n = 0; n < texels.count(); ++n) {
    const std::array<double, 3> rgb = decoded(n);
    for (std::size_t c = 0; c < 3; ++c) sum[c] += rgb[c];
  }
  const auto count = static_cast<double>(texels.count());
  return {sum[0] / count, sum[1] / count, sum[2] / count};
}

}  // namespace strahl::kinds
