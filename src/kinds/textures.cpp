// SPDX-License-Identifier: MIT
#include "kinds/textures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinds/reflectance.h"

namespace strahl::kinds {
namespace {

bool is_finite_map(const std::array<double, 6>& to_uv) {
  return std::all_of(to_uv.begin(), to_uv.end(), [](double x) { return std::isfinite(x); });
}

bool is_light(const Rgb& c) {
  const auto is_sound = [](double x) { return std::isfinite(x) && x >= 0; };
  return is_sound(c.r) && is_sound(c.g) && is_sound(c.b);
}

struct TextureRow {
  bool is_unbounded;

  void require_colour(const Rgb& colour, const char* what, TextureFacts& facts) const {
    if (is_unbounded && !is_light(colour))
      facts.faults.push_back(std::string(what) + " must be finite and not negative");
    if (!is_unbounded && !is_reflectance(colour)) facts.faults.push_back(std::string(what) + " must lie in [0, 1]");
  }
  TextureFacts operator()(const Checkerboard& board) const {
    const Rgb &a = board.color0, &b = board.color1;
    TextureFacts facts{.entry = "checkerboard",
                       .reals = {a.r, a.g, a.b, b.r, b.g, b.b},
                       .mean = {0.5 * (a.r + b.r), 0.5 * (a.g + b.g), 0.5 * (a.b + b.b)},
                       .bitmap = nullptr,
                       .attribute = {},
                       .faults = {}};
    facts.reals.insert(facts.reals.end(), board.to_uv.begin(), board.to_uv.end());
    require_colour(a, "the colours of a texture", facts);
    require_colour(b, "the colours of a texture", facts);
    if (!is_finite_map(board.to_uv)) facts.faults.emplace_back("to_uv must be finite");
    return facts;
  }
  TextureFacts operator()(const Bitmap& bitmap) const {
    TextureFacts facts{.entry = "bitmap",
                       .reals = {bitmap.to_uv.begin(), bitmap.to_uv.end()},
                       .mean = times(bitmap.scale, bitmap.mean),
                       .bitmap = &bitmap,
                       .attribute = {},
                       .faults = {}};
    facts.reals.insert(facts.reals.end(), {bitmap.scale.r, bitmap.scale.g, bitmap.scale.b});
    require_colour(bitmap.scale, "the scale of a bitmap", facts);
    if (!bitmap.texels || bitmap.texels->count() == 0) facts.faults.emplace_back("a bitmap needs an image");
    if (!is_finite_map(bitmap.to_uv)) facts.faults.emplace_back("to_uv must be finite");
    return facts;
  }
  TextureFacts operator()(const AttributeTexture& attribute) const {
    const double most = is_unbounded ? static_cast<double>(std::numeric_limits<float>::max()) : 1;
    const double half = attribute.scale / 2;
    TextureFacts facts{.entry = "mesh_attribute",
                       .reals = {attribute.scale, most},
                       .mean = {half, half, half},
                       .bitmap = nullptr,
                       .attribute = attribute.name,
                       .faults = {}};
    if (!(std::isfinite(attribute.scale) && attribute.scale >= 0))
      facts.faults.emplace_back("the scale of a mesh_attribute must be finite and not negative");
    if (!attribute.name.starts_with("vertex_") && !attribute.name.starts_with("face_"))
      facts.faults.emplace_back("the name of a mesh_attribute must begin with vertex_ or face_");
    return facts;
  }
};

/// One without its row does not compile.
struct BrightestRow {
  const Scene& scene;
  bool is_unbounded;

  Rgb operator()(const Checkerboard& board) const {
    const Rgb &a = board.color0, &b = board.color1;
    return {std::max(a.r, b.r), std::max(a.g, b.g), std::max(a.b, b.b)};
  }
  Rgb operator()(const Bitmap& bitmap) const { return times(bitmap.scale, brightest_of(*bitmap.texels, bitmap.curve)); }
  Rgb operator()(const AttributeTexture& attribute) const {
    Rgb most;
    for_each_shape(scene, [&](const Shape& shape) {
      const auto* mesh = std::get_if<Mesh>(&shape.geometry);
      if (mesh == nullptr) return;
      for (const MeshAttribute& there : mesh->attributes)
        if (there.name == attribute.name)
          for (const Rgb& c : there.values)
            most = {std::max(most.r, c.r), std::max(most.g, c.g), std::max(most.b, c.b)};
    });
    most = times(attribute.scale, most);
    return is_unbounded ? most : Rgb{std::min(most.r, 1.0), std::min(most.g, 1.0), std::min(most.b, 1.0)};
  }
};

}  // namespace

TextureFacts texture(const Texture& texture) { return std::visit(TextureRow{texture.is_unbounded}, texture.pattern); }

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

Rgb brightest_of(const Texels& texels, const TexelCurve& curve) {
  const TexelDecoder decoded(texels, curve);
  Rgb most;
  for (std::size_t n = 0; n < texels.count(); ++n) {
    const std::array<double, 3> rgb = decoded(n);
    most = {std::max(most.r, rgb[0]), std::max(most.g, rgb[1]), std::max(most.b, rgb[2])};
  }
  return most;
}

Rgb brightest(const Scene& scene, int texture) {
  const Texture& found = scene.textures.at(static_cast<std::size_t>(texture));
  return std::visit(BrightestRow{scene, found.is_unbounded}, found.pattern);
}

}  // namespace strahl::kinds
