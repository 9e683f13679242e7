// SPDX-License-Identifier: MIT
// Images by their first bytes.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "errors.h"
#include "image/codecs.h"
#include "image/file_bytes.h"
#include "image/named_colours.h"
#include "image/png_codes.h"
#include "image/texels_files.h"

namespace strahl {
namespace {

Texels read_png_texels(const std::string& path, const std::string& bytes) {
  const PngCodes png = read_png_codes(
      path, bytes, [&](int width, int height, std::size_t, std::size_t) { check_texel_count(path, width, height); });
  const std::size_t count = static_cast<std::size_t>(png.width) * static_cast<std::size_t>(png.height);
  const std::size_t colours = png.channels <= 2 ? 1 : 3;  // Without alpha.
  std::vector<std::uint16_t> wide;
  std::vector<std::uint8_t> narrow;
  png.is_wide ? wide.reserve(count * colours) : narrow.reserve(count * colours);
  for (std::size_t n = 0; n < count; ++n)
    for (std::size_t c = 0; c < colours; ++c) {
      const std::size_t code = png.code(n * png.channels + c);
      if (png.is_wide)
        wide.push_back(static_cast<std::uint16_t>(code));
      else
        narrow.push_back(static_cast<std::uint8_t>(code));
    }
  const int channels = static_cast<int>(colours);
  if (png.is_wide) return texels_of_words(png.width, png.height, channels, wide.data(), TexelFormat::bits_16);
  return texels_of_bytes(png.width, png.height, channels, narrow.data());
}

/// The three that have a colour's names; else Y.
std::vector<std::size_t> colours_of(const Image& image, const std::string& path) {
  if (const std::optional<NamedColours> colours = named_colours(image.channels))
    return {colours->places.begin(), colours->places.end()};
  const auto y = std::find(image.channels.begin(), image.channels.end(), "Y");
  if (y != image.channels.end()) return {static_cast<std::size_t>(y - image.channels.begin())};
  if (image.channels.size() == 1) return {0};
  throw InputError(fmt::format("\"{}\" has the channels {}; an image has R, G and B, or X, Y and Z, or Y", path,
                               fmt::join(image.channels, ", ")));
}

Texels texels_of_image(Image image, const std::string& path, TexelUse use) {
  check_texel_count(path, image.width, image.height);
  const std::vector<std::size_t> colours = colours_of(image, path);
  // In place, as channels stand in the order of colours.
  const std::size_t step = image.channels.size(), count = image.data.size() / step;
  if (colours.size() < step)
    for (std::size_t n = 0; n < count; ++n)
      for (std::size_t c = 0; c < colours.size(); ++c)
        image.data[n * colours.size() + c] = image.data[n * step + colours[c]];
  image.data.resize(count * colours.size());
  return repaired_texels(image.width, image.height, static_cast<int>(colours.size()), std::move(image.data), use);
}

Texels read_exr_texels(const std::string& path, const std::string& bytes, TexelUse use) {
  ExrTexture texture = read_exr_texture(path, bytes);
  Texels texels = texels_of_image(std::move(texture.image), path, use);
  if (texture.parts > 1) texels.left_out = fmt::format("it has {} parts, of which the first is read", texture.parts);
  return texels;
}

Texels read_by_first_bytes(const std::string& path, TexelUse use) {
  using namespace std::string_view_literals;
  const std::string bytes = read_file(path);
  const auto begins = [&](std::string_view start) { return std::string_view(bytes).starts_with(start); };
  if (begins("\x89PNG\r\n\x1a\n"sv)) return read_png_texels(path, bytes);
  if (begins("\xff\xd8\xff"sv)) return read_jpeg_texels(path, bytes);
  if (begins("\x76\x2f\x31\x01"sv)) return read_exr_texels(path, bytes, use);
  if (begins("PF"sv) || begins("Pf"sv)) return texels_of_image(read_pfm(path, bytes), path, use);
  if (begins("#?"sv) || begins("BM"sv) || is_stb_image(bytes)) return read_stb_texels(path, bytes);
  throw InputError(fmt::format(
      "\"{}\" is not an image that can be read: PNG, JPEG, OpenEXR, Radiance HDR, TGA, BMP and PFM are", path));
}

}  // namespace

void check_texel_count(const std::string& path, std::int64_t width, std::int64_t height) {
  if (width < 1 || height < 1 || width > most_texels / height)
    throw InputError(fmt::format("\"{}\" has {} x {} texels; an image has at most {} (16384 x 16384), and at least one",
                                 path, width, height, most_texels));
  if (std::max(width, height) > longest_side)
    throw InputError(
        fmt::format("\"{}\" has {} x {} texels; a side of an image has at most {}", path, width, height, longest_side));
}

Texels read_texels(const std::string& path, TexelUse use) {
  Texels texels = read_by_first_bytes(path, use);
  texels.file = path;
  return texels;
}

}  // namespace strahl
