// SPDX-License-Identifier: MIT
// <texture type="bitmap">, with the names and values of Mitsuba 0.x.
#include <fmt/format.h>

#include <map>
#include <string>

#include "kinds/textures.h"
#include "scene/readers/read_choice.h"
#include "scene/readers/read_texture.h"

namespace strahl {
namespace {

/// gamma is of Mitsuba 0.x: -1 is sRGB.
TexelCurve read_curve(Properties& properties) {
  const bool is_raw = properties.boolean("raw").value_or(false);
  const std::optional<double> gamma = properties.number("gamma");
  if (is_raw || gamma == 1) return {TexelCurve::Kind::linear, 1};
  if (!gamma || *gamma == -1) return {TexelCurve::Kind::srgb, 1};
  if (*gamma > 0) return {TexelCurve::Kind::power, *gamma};
  properties.diagnostics().error(properties.where("gamma"),
                                 fmt::format("gamma {} is neither greater than 0 nor -1 (sRGB)", *gamma));
  return {};
}

TextureWrap read_wrap(Properties& properties) {
  const std::map<std::string, TextureWrap> meanings = {
      {"repeat", TextureWrap::repeat}, {"mirror", TextureWrap::mirror}, {"clamp", TextureWrap::clamp}};
  const TextureWrap u = choice(properties, "wrap_mode_u", meanings, TextureWrap::repeat);
  const TextureWrap v = choice(properties, "wrap_mode_v", meanings, u);
  if (u != v)
    properties.diagnostics().warning(properties.where("wrap_mode_v"),
                                     "wrap_mode_u and wrap_mode_v differ; that of u is used for both");
  return choice(properties, "wrap_mode", meanings, u);
}

}  // namespace

Texture read_bitmap(Properties& properties, SceneBuilder& builder, ColorUse use) {
  Bitmap bitmap;
  bitmap.texels = read_image_file(properties, builder, use == ColorUse::height ? TexelUse::heights : TexelUse::light);
  bitmap.curve = read_curve(properties);
  // Of Mitsuba 0.x: filters for distant surfaces, which have no counterpart.
  bitmap.filter = choice<TextureFilter>(properties, "filter_type",
                                        {{"bilinear", TextureFilter::bilinear},
                                         {"nearest", TextureFilter::nearest},
                                         {"trilinear", TextureFilter::bilinear},
                                         {"ewa", TextureFilter::bilinear}},
                                        TextureFilter::bilinear);
  bitmap.wrap = read_wrap(properties);
  bitmap.to_uv = read_uv_map(properties);
  properties.accept({"format", "accel", "max_anisotropy", "cache"});
  if (bitmap.texels) bitmap.mean = kinds::mean_of(*bitmap.texels, bitmap.curve);
  Texture texture;
  texture.pattern = bitmap;
  return texture;
}

}  // namespace strahl
