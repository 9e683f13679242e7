// SPDX-License-Identifier: MIT
#include "image/texels.h"

#include <half.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "image/srgb.h"

namespace strahl {
namespace {

constexpr int rgbe_bias = 128 + 8;  // Mantissas are integers of 8 bits.

Texels blank(int width, int height, int channels, TexelFormat format) {
  Texels texels;
  texels.width = width;
  texels.height = height;
  texels.is_grey = channels == 1;
  texels.format = format;
  return texels;
}

double linear(double code, const TexelCurve& curve) {
  switch (curve.kind) {
    case TexelCurve::Kind::linear:
      return code;
    case TexelCurve::Kind::srgb:
      return linear_from_srgb(code);
    case TexelCurve::Kind::power:
      break;
  }
  return std::pow(code, curve.gamma);
}

double value_of_half(std::uint16_t bits) {
  Imath::half value;
  value.setBits(bits);
  return static_cast<double>(static_cast<float>(value));
}

/// What a half without a sign holds: kernels read no sign (cl/textures/texels_lanes.h).
bool is_half(float value) {
  if (!(value >= 0 && value <= 65504.0F)) return false;
  return static_cast<float>(Imath::half(value)) == value;
}

/// Neither negative, nor infinite, nor no number.
bool is_light(float value) { return value >= 0 && value <= std::numeric_limits<float>::max(); }

std::uint32_t word(const Texels& texels, std::size_t at) { return static_cast<std::uint32_t>(texels.words[at]); }

/// The codes of a texel of integers or halves.
std::array<std::uint32_t, 3> codes_of(const Texels& texels, std::size_t n) {
  if (texels.format == TexelFormat::bits_8) {
    if (!texels.is_grey) return {word(texels, n) & 255U, word(texels, n) >> 8 & 255U, word(texels, n) >> 16 & 255U};
    const std::uint32_t code = word(texels, n / 4) >> 8 * (n % 4) & 255U;
    return {code, code, code};
  }
  if (!texels.is_grey) return {word(texels, 2 * n) & 65535U, word(texels, 2 * n) >> 16, word(texels, 2 * n + 1)};
  const std::uint32_t code = word(texels, n / 2) >> 16 * (n % 2) & 65535U;
  return {code, code, code};
}

/// Codes of 16 bits in words: two of grey in one, a texel of rgb in two.
template <typename Code>
Texels packed(Texels texels, const Code& code) {
  const std::size_t count = texels.count();
  const auto one = [&](std::size_t i) { return static_cast<std::int32_t>(code(i)); };
  const auto two = [&](std::size_t i) { return static_cast<std::int32_t>(code(i) | std::uint32_t{code(i + 1)} << 16); };
  texels.words.resize(texels.is_grey ? (count + 1) / 2 : 2 * count);
  if (texels.is_grey) {
    for (std::size_t i = 0; i < count / 2; ++i) texels.words[i] = two(2 * i);
    if (count % 2 != 0) texels.words.back() = one(count - 1);
    return texels;
  }
  for (std::size_t n = 0; n < count; ++n) {
    texels.words[2 * n] = two(3 * n);
    texels.words[2 * n + 1] = one(3 * n + 2);
  }
  return texels;
}

}  // namespace

std::vector<double> decoding_table(TexelFormat format, const TexelCurve& curve) {
  if (format == TexelFormat::real) return {};
  const bool is_wide = format == TexelFormat::bits_16 || format == TexelFormat::half;
  std::vector<double> table(is_wide ? 65536 : 256);
  const auto last = static_cast<double>(table.size() - 1);
  for (std::size_t code = 0; code < table.size(); ++code) {
    if (format == TexelFormat::half)
      table[code] = value_of_half(static_cast<std::uint16_t>(code));
    else if (format == TexelFormat::rgbe)
      table[code] = code == 0 ? 0 : std::ldexp(1.0, static_cast<int>(code) - rgbe_bias);
    else
      table[code] = linear(static_cast<double>(code) / last, curve);
  }
  return table;
}

std::array<double, 3> TexelDecoder::operator()(std::size_t number) const {
  if (texels_.format == TexelFormat::real) {
    const auto at = [&](std::size_t i) { return static_cast<double>(texels_.reals[i]); };
    if (texels_.is_grey) return {at(number), at(number), at(number)};
    return {at(3 * number), at(3 * number + 1), at(3 * number + 2)};
  }
  if (texels_.format == TexelFormat::rgbe) {
    const std::uint32_t all = word(texels_, number);
    const double power = table_[all >> 24];
    return {power * (all & 255U), power * (all >> 8 & 255U), power * (all >> 16 & 255U)};
  }
  const std::array<std::uint32_t, 3> codes = codes_of(texels_, number);
  return {table_[codes[0]], table_[codes[1]], table_[codes[2]]};
}

Texels texels_of_bytes(int width, int height, int channels, const std::uint8_t* codes) {
  Texels texels = blank(width, height, channels, TexelFormat::bits_8);
  const std::size_t count = texels.count();
  texels.words.resize(texels.is_grey ? (count + 3) / 4 : count);
  for (std::size_t n = 0; n < count; ++n)
    for (std::size_t c = 0; c < (texels.is_grey ? 1U : 3U); ++c) {
      const std::size_t at = texels.is_grey ? n / 4 : n, place = texels.is_grey ? n % 4 : c;
      const std::uint32_t code = codes[texels.is_grey ? n : 3 * n + c];
      texels.words[at] = static_cast<std::int32_t>(word(texels, at) | code << 8 * place);
    }
  return texels;
}

Texels texels_of_words(int width, int height, int channels, const std::uint16_t* codes, TexelFormat format) {
  return packed(blank(width, height, channels, format), [&](std::size_t i) { return codes[i]; });
}

Texels texels_of_rgbe(int width, int height, const float* values) {
  Texels texels = blank(width, height, 3, TexelFormat::rgbe);
  texels.words.resize(texels.count());
  for (std::size_t n = 0; n < texels.count(); ++n) {
    const float* rgb = values + 3 * n;
    int exponent = 0;
    std::frexp(std::max({rgb[0], rgb[1], rgb[2]}), &exponent);
    exponent += 128;
    if (!(std::max({rgb[0], rgb[1], rgb[2]}) > 0) || exponent < 1) continue;
    std::uint32_t all = static_cast<std::uint32_t>(exponent) << 24;
    for (std::size_t c = 0; c < 3; ++c)
      all |= static_cast<std::uint32_t>(std::ldexp(rgb[c], rgbe_bias - exponent)) << 8 * c;
    texels.words[n] = static_cast<std::int32_t>(all);
  }
  return texels;
}

Texels texels_of_floats(int width, int height, int channels, std::vector<float> values) {
  if (std::all_of(values.begin(), values.end(), is_half))
    return packed(blank(width, height, channels, TexelFormat::half),
                  [&](std::size_t i) { return Imath::half(values[i]).bits(); });
  Texels texels = blank(width, height, channels, TexelFormat::real);
  texels.reals = std::move(values);
  return texels;
}

namespace {

bool is_height(float value) { return std::isfinite(value); }

}  // namespace

Texels repaired_texels(int width, int height, int channels, std::vector<float> values, TexelUse use) {
  const auto is_sound = use == TexelUse::heights ? is_height : is_light;
  const auto step = static_cast<std::size_t>(channels);
  std::size_t repaired = 0;
  if (!std::all_of(values.begin(), values.end(), is_sound)) {
    float largest = 0;
    for (const float value : values)
      if (is_sound(value)) largest = std::max(largest, value);
    for (std::size_t i = 0; i < values.size(); i += step) {
      bool is_faulty = false;
      for (std::size_t c = i; c < i + step; ++c) {
        if (is_sound(values[c])) continue;
        values[c] = values[c] > 0 ? largest : 0;
        is_faulty = true;
      }
      repaired += is_faulty ? 1 : 0;
    }
  }
  Texels texels = texels_of_floats(width, height, channels, std::move(values));
  texels.repaired = repaired;
  return texels;
}

namespace {

/// The old texels that a new one covers, with their shares of it.
struct Cover {
  std::size_t first = 0;
  std::vector<double> shares;
};

std::vector<Cover> covers(int from, int to) {
  std::vector<Cover> all(static_cast<std::size_t>(to));
  const double width = static_cast<double>(from) / to;
  for (int i = 0; i < to; ++i) {
    const double begin = i * width, end = i + 1 == to ? from : (i + 1) * width;
    Cover& cover = all[static_cast<std::size_t>(i)];
    cover.first = static_cast<std::size_t>(begin);
    for (auto n = static_cast<int>(begin); n < end; ++n)
      cover.shares.push_back((std::min(end, n + 1.0) - std::max(begin, static_cast<double>(n))) / width);
  }
  return all;
}

}  // namespace

Texels reduced(const Texels& texels, const TexelCurve& curve) {
  const int width = std::max(texels.width / 2, 1), height = std::max(texels.height / 2, 1);
  const std::size_t channels = texels.is_grey ? 1 : 3;
  const TexelDecoder decoded(texels, curve);
  const std::vector<Cover> columns = covers(texels.width, width), rows = covers(texels.height, height);
  std::vector<std::uint16_t> codes;
  codes.reserve(channels * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (const Cover& row : rows)
    for (const Cover& column : columns) {
      std::array<double, 3> sum{};
      for (std::size_t y = 0; y < row.shares.size(); ++y)
        for (std::size_t x = 0; x < column.shares.size(); ++x) {
          const std::array<double, 3> rgb =
              decoded((row.first + y) * static_cast<std::size_t>(texels.width) + column.first + x);
          for (std::size_t c = 0; c < 3; ++c) sum[c] += row.shares[y] * column.shares[x] * rgb[c];
        }
      for (std::size_t c = 0; c < channels; ++c) codes.push_back(Imath::half(static_cast<float>(sum[c])).bits());
    }
  return texels_of_words(width, height, static_cast<int>(channels), codes.data(), TexelFormat::half);
}

Clamped clamped_to_one(const Texels& texels) {
  if (texels.format == TexelFormat::bits_8 || texels.format == TexelFormat::bits_16) return {texels, 0};
  const TexelDecoder decoded(texels, {});
  const std::size_t channels = texels.is_grey ? 1 : 3;
  std::vector<float> values;
  std::size_t changed = 0;
  values.reserve(channels * texels.count());
  for (std::size_t n = 0; n < texels.count(); ++n) {
    const std::array<double, 3> rgb = decoded(n);
    changed += std::max({rgb[0], rgb[1], rgb[2]}) > 1 ? 1 : 0;
    for (std::size_t c = 0; c < channels; ++c) values.push_back(static_cast<float>(std::min(rgb[c], 1.0)));
  }
  if (changed == 0) return {texels, 0};
  Clamped clamped{texels_of_floats(texels.width, texels.height, static_cast<int>(channels), values), changed};
  clamped.texels.file = texels.file;
  return clamped;
}

}  // namespace strahl
