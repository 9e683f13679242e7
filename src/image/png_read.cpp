// SPDX-License-Identifier: MIT
// PNG reader: every colour type and depth to linear floats. The curve is sRGB unless the file has a gAMA chunk that
// says otherwise and no sRGB chunk or colour profile (profiles are taken for sRGB); alpha is linear.
// Format: Portable Network Graphics Specification, second edition, W3C 2003.
#include <fmt/format.h>
#include <png.h>

#include <cmath>
#include <cstring>

#include "errors.h"
#include "image/codecs.h"
#include "image/file_bytes.h"
#include "image/png_errors.h"
#include "image/srgb.h"

namespace strahl {
namespace {

struct Reader {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, throw_png_error, ignore_png_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;

  Reader() = default;
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;
};

struct Source {
  const std::string& bytes;
  std::size_t position = 0;
};

void read_bytes(png_structp png, png_bytep data, std::size_t size) {
  auto& source = *static_cast<Source*>(png_get_io_ptr(png));
  if (size > source.bytes.size() - source.position) png_error(png, "the file ends too early");
  std::memcpy(data, source.bytes.data() + source.position, size);
  source.position += size;
}

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

std::map<std::string, std::string> metadata_of(const Reader& reader) {
  std::map<std::string, std::string> metadata;
  png_textp texts = nullptr;
  const int count = png_get_text(reader.png, reader.info, &texts, nullptr);
  for (int i = 0; i < count; ++i) {
    const bool is_utf8 = texts[i].compression >= PNG_ITXT_COMPRESSION_NONE;
    std::string& value = metadata[utf8_from_latin1(texts[i].key)];
    if (!value.empty()) value += '\n';
    value += is_utf8 ? texts[i].text : utf8_from_latin1(texts[i].text);
  }
  return metadata;
}

/// Linear light of every code.
std::vector<float> decoding_table(const Reader& reader, bool wide) {
  double file_gamma = 0;
  const bool has_curve = png_get_valid(reader.png, reader.info, PNG_INFO_sRGB | PNG_INFO_iCCP) != 0;
  const bool has_gamma = !has_curve && png_get_gAMA(reader.png, reader.info, &file_gamma) != 0;
  const bool is_srgb = !has_gamma || std::fabs(file_gamma - 0.45455) < 1e-3;
  std::vector<float> table(wide ? 65536 : 256);
  for (std::size_t code = 0; code < table.size(); ++code) {
    const double encoded = static_cast<double>(code) / static_cast<double>(table.size() - 1);
    table[code] = static_cast<float>(is_srgb ? linear_from_srgb(encoded) : std::pow(encoded, 1 / file_gamma));
  }
  return table;
}

Image decode(const Reader& reader, const std::string& path, const std::string& bytes) {
  Source source{bytes};
  png_set_read_fn(reader.png, &source, read_bytes);
  png_read_info(reader.png, reader.info);
  png_set_expand(reader.png);  // Palettes, 1 to 4 bits and transparent colours to 8 bits or more.
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);

  Image image;
  image.width = static_cast<int>(png_get_image_width(reader.png, reader.info));
  image.height = static_cast<int>(png_get_image_height(reader.png, reader.info));
  static const std::vector<std::string> names[] = {{"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
  const std::size_t samples = png_get_channels(reader.png, reader.info);
  image.channels = names[samples - 1];
  check_picture_size(path, image.width, image.height, samples, bytes.size());

  const std::size_t row_bytes = png_get_rowbytes(reader.png, reader.info);
  std::vector<png_byte> pixels(row_bytes * static_cast<std::size_t>(image.height));
  std::vector<png_bytep> rows;
  for (int y = 0; y < image.height; ++y) rows.push_back(pixels.data() + static_cast<std::size_t>(y) * row_bytes);
  png_read_image(reader.png, rows.data());
  png_read_end(reader.png, reader.info);

  const bool wide = png_get_bit_depth(reader.png, reader.info) == 16;
  const std::vector<float> linear = decoding_table(reader, wide);
  const bool has_alpha = samples % 2 == 0;
  image.data.resize(image.index(0, image.height, 0));
  for (std::size_t i = 0; i < image.data.size(); ++i) {
    const std::size_t code = wide ? pixels[2 * i] * 256u + pixels[2 * i + 1] : pixels[i];
    const bool is_alpha = has_alpha && i % samples == samples - 1;
    image.data[i] = is_alpha ? static_cast<float>(code) / static_cast<float>(linear.size() - 1) : linear[code];
  }
  image.metadata = metadata_of(reader);
  return image;
}

}  // namespace

Image read_png(const std::string& path) {
  const std::string bytes = read_file(path);
  if (bytes.size() < 8 || png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, 8) != 0) {
    throw InputError(fmt::format("\"{}\": not a PNG file", path));
  }
  try {
    const Reader reader;
    if (!reader.info) throw std::bad_alloc();
    return decode(reader, path, bytes);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& e) {
    throw InputError(fmt::format("\"{}\": damaged PNG file: {}", path, e.what()));
  }
}

}  // namespace strahl
