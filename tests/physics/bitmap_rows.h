// SPDX-License-Identifier: MIT
// Bitmaps of every format, wrap and filter for the tests of textures, and their values by another way.
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include "kinds/textures.h"
#include "physics/tiers.h"

namespace strahl::test {

/// 4 x 3 texels of any format, grey or not.
[[nodiscard]] inline Texels texels_of(TexelFormat format, bool is_grey) {
  constexpr int width = 4, height = 3;
  const int channels = is_grey ? 1 : 3;
  std::mt19937 engine(8);
  std::vector<std::uint8_t> bytes;
  std::vector<std::uint16_t> words;
  std::vector<float> floats;
  for (int i = 0; i < width * height * channels; ++i) {
    bytes.push_back(static_cast<std::uint8_t>(engine()));
    words.push_back(static_cast<std::uint16_t>(engine()));
    // Halves hold 1 / 1024, not 1 / 3.
    floats.push_back(static_cast<float>(engine() % 1025) / (format == TexelFormat::half ? 1024 : 3072));
  }
  switch (format) {
    case TexelFormat::bits_8:
      return texels_of_bytes(width, height, channels, bytes.data());
    case TexelFormat::bits_16:
      return texels_of_words(width, height, channels, words.data(), format);
    case TexelFormat::rgbe:
      return texels_of_rgbe(width, height, floats.data());
    case TexelFormat::half:
    case TexelFormat::real:
      break;
  }
  return texels_of_floats(width, height, channels, floats);
}

[[nodiscard]] inline Bitmap bitmap_of(TexelFormat format, bool is_grey, TextureFilter filter, TextureWrap wrap,
                                      const TexelCurve& curve = {}) {
  Bitmap bitmap;
  bitmap.texels = std::make_shared<const Texels>(texels_of(format, is_grey));
  bitmap.filter = filter;
  bitmap.wrap = wrap;
  bitmap.curve = curve;
  bitmap.mean = kinds::mean_of(*bitmap.texels, curve);
  return bitmap;
}

[[nodiscard]] inline std::vector<Bitmap> bitmaps() {
  using enum TexelFormat;
  using enum TextureFilter;
  using enum TextureWrap;
  std::vector<Bitmap> all = {bitmap_of(bits_8, false, bilinear, repeat),
                             bitmap_of(bits_8, true, bilinear, repeat, {TexelCurve::Kind::linear, 1}),
                             bitmap_of(bits_16, false, bilinear, mirror),
                             bitmap_of(bits_16, true, bilinear, mirror, {TexelCurve::Kind::power, 1.8}),
                             bitmap_of(half, false, bilinear, clamp),
                             bitmap_of(half, true, bilinear, clamp),
                             bitmap_of(real, false, bilinear, repeat),
                             bitmap_of(real, true, bilinear, mirror),
                             bitmap_of(rgbe, false, bilinear, repeat),
                             bitmap_of(bits_8, false, nearest, repeat),
                             bitmap_of(bits_8, false, nearest, mirror),
                             bitmap_of(bits_8, false, nearest, clamp)};
  all.push_back(all.front());
  all.back().to_uv = {0, 2, 0.125, -1, 0, 0.0625};
  return all;
}

/// Over which the mean is that of the texels; 0: there is none.
[[nodiscard]] inline double period(const Bitmap& bitmap) {
  return bitmap.wrap == TextureWrap::repeat ? 1 : bitmap.wrap == TextureWrap::mirror ? 2 : 0;
}

/// The texel at any column or row of the infinite plane, of `size` in the image.
[[nodiscard]] inline int wrapped(int at, int size, TextureWrap wrap) {
  if (wrap == TextureWrap::clamp) return std::clamp(at, 0, size - 1);
  const int turns = static_cast<int>(std::floor(static_cast<double>(at) / size)), inside = at - turns * size;
  return wrap == TextureWrap::mirror && turns % 2 != 0 ? size - 1 - inside : inside;
}

/// Texel by texel of the infinite plane.
[[nodiscard]] inline Triad bitmap_value(const Bitmap& bitmap, const TexelDecoder& decoded, double u, double v) {
  const auto& m = bitmap.to_uv;
  const Texels& texels = *bitmap.texels;
  const double x = (m[0] * u + m[1] * v + m[2]) * texels.width, y = (m[3] * u + m[4] * v + m[5]) * texels.height;
  const auto texel = [&](double column, double row) {
    return decoded(static_cast<std::size_t>(wrapped(static_cast<int>(row), texels.height, bitmap.wrap) * texels.width +
                                            wrapped(static_cast<int>(column), texels.width, bitmap.wrap)));
  };
  if (bitmap.filter == TextureFilter::nearest) return texel(std::floor(x), std::floor(y));
  const double left = std::floor(x - 0.5), top = std::floor(y - 0.5), s = x - 0.5 - left, t = y - 0.5 - top;
  const Triad a = texel(left, top), b = texel(left + 1, top), c = texel(left, top + 1), d = texel(left + 1, top + 1);
  Triad value{};
  for (std::size_t k = 0; k < 3; ++k)
    value[k] = (1 - t) * ((1 - s) * a[k] + s * b[k]) + t * ((1 - s) * c[k] + s * d[k]);
  return value;
}

}  // namespace strahl::test
