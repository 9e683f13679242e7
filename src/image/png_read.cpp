// SPDX-License-Identifier: MIT
// PNG reader: every colour type and depth to linear floats. The curve is sRGB unless the file has a gAMA chunk that
// says otherwise and no sRGB chunk or colour profile (profiles are taken for sRGB); alpha is linear.
// Format: Portable Network Graphics Specification, second edition, W3C 2003.
#include <cmath>

#include "image/codecs.h"
#include "image/png_codes.h"
#include "image/srgb.h"

namespace strahl {
namespace {

std::string utf8_from_latin1(const char* text) {
  std::string utf8;
  for (; *text; ++text) {
    const auto c = static_cast<unsigned char>(*text);
    if (c < 128) {
      utf8 += *text;
    } else {
      utf8 += static_cast<char>(0xC0 | (c >> 6));
      utf8 += static_cast<char>(0x80 | (c & 0x3F));
    }
  }
  return utf8;
}

std::map<std::string, std::string> metadata_of(png_structp png, png_infop info) {
  std::map<std::string, std::string> metadata;
  png_textp texts = nullptr;
  const int count = png_get_text(png, info, &texts, nullptr);
  for (int i = 0; i < count; ++i) {
    const bool is_utf8 = texts[i].compression >= PNG_ITXT_COMPRESSION_NONE;
    std::string& value = metadata[utf8_from_latin1(texts[i].key)];
    if (!value.empty()) value += '\n';
    value += is_utf8 ? texts[i].text : utf8_from_latin1(texts[i].text);
  }
  return metadata;
}

/// Linear light of every code.
std::vector<float> linear_light(png_structp png, png_infop info) {
  const bool is_wide = png_get_bit_depth(png, info) == 16;
  double file_gamma = 0;
  const bool has_curve = png_get_valid(png, info, PNG_INFO_sRGB | PNG_INFO_iCCP) != 0;
  const bool has_gamma = !has_curve && png_get_gAMA(png, info, &file_gamma) != 0;
  const bool is_srgb = !has_gamma || std::fabs(file_gamma - 0.45455) < 1e-3;
  std::vector<float> table(is_wide ? 65536 : 256);
  for (std::size_t code = 0; code < table.size(); ++code) {
    const double encoded = static_cast<double>(code) / static_cast<double>(table.size() - 1);
    table[code] = static_cast<float>(is_srgb ? linear_from_srgb(encoded) : std::pow(encoded, 1 / file_gamma));
  }
  return table;
}

}  // namespace

Image read_png(const std::string& path, const std::string& bytes) {
  const auto check = [&](int width, int height, std::size_t channels, std::size_t file_bytes) {
    check_picture_size(path, width, height, channels, file_bytes);
  };
  Image image;
  std::vector<float> linear;
  const PngCodes codes = read_png_codes(path, bytes, check, [&](png_structp png, png_infop info) {
    linear = linear_light(png, info);
    image.metadata = metadata_of(png, info);
  });
  image.width = codes.width;
  image.height = codes.height;
  static const std::vector<std::string> names[] = {{"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
  image.channels = names[codes.channels - 1];
  const bool has_alpha = codes.channels % 2 == 0;
  image.data.resize(image.index(0, image.height, 0));
  for (std::size_t i = 0; i < image.data.size(); ++i) {
    const std::size_t code = codes.code(i);
    const bool is_alpha = has_alpha && i % codes.channels == codes.channels - 1;
    image.data[i] = is_alpha ? static_cast<float>(code) / static_cast<float>(linear.size() - 1) : linear[code];
  }
  return image;
}

}  // namespace strahl
