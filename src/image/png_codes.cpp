// SPDX-License-Identifier: MIT
#include "image/png_codes.h"

#include <fmt/format.h>

#include <cstring>

#include "errors.h"
#include "image/png_errors.h"

namespace strahl {
namespace {

struct PngReader {
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, throw_png_error, ignore_png_warning);
  png_infop info = png ? png_create_info_struct(png) : nullptr;

  PngReader() = default;
  ~PngReader() { png_destroy_read_struct(&png, &info, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
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

/// Once it is expanded.
std::size_t channels_of(const PngReader& reader) {
  const int type = png_get_color_type(reader.png, reader.info);
  const bool has_alpha =
      (type & PNG_COLOR_MASK_ALPHA) != 0 || png_get_valid(reader.png, reader.info, PNG_INFO_tRNS) != 0;
  return ((type & PNG_COLOR_MASK_COLOR) != 0 ? 3U : 1U) + (has_alpha ? 1U : 0U);
}

PngCodes decode(const PngReader& reader, const std::string& bytes, const PngCheck& check, const PngVisit& visit) {
  Source source{bytes};
  png_set_read_fn(reader.png, &source, read_bytes);
  // libpng's own are a million, and its refusal tells no more than that the header is invalid; `check` says what is.
  png_set_user_limits(reader.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
  png_read_info(reader.png, reader.info);
  check(static_cast<int>(png_get_image_width(reader.png, reader.info)),
        static_cast<int>(png_get_image_height(reader.png, reader.info)), channels_of(reader), bytes.size());
  png_set_expand(reader.png);  // Palettes, 1 to 4 bits and transparent colours to 8 bits or more.
  png_set_interlace_handling(reader.png);
  png_read_update_info(reader.png, reader.info);  // Takes memory for a row: not before the check.

  PngCodes codes;
  codes.width = static_cast<int>(png_get_image_width(reader.png, reader.info));
  codes.height = static_cast<int>(png_get_image_height(reader.png, reader.info));
  codes.channels = png_get_channels(reader.png, reader.info);
  codes.is_wide = png_get_bit_depth(reader.png, reader.info) == 16;

  const std::size_t row_bytes = png_get_rowbytes(reader.png, reader.info);
  codes.bytes.resize(row_bytes * static_cast<std::size_t>(codes.height));
  std::vector<png_bytep> rows;
  for (int y = 0; y < codes.height; ++y) rows.push_back(codes.bytes.data() + static_cast<std::size_t>(y) * row_bytes);
  png_read_image(reader.png, rows.data());
  png_read_end(reader.png, reader.info);
  if (visit) visit(reader.png, reader.info);
  return codes;
}

}  // namespace

PngCodes read_png_codes(const std::string& path, const std::string& bytes, const PngCheck& check,
                        const PngVisit& visit) {
  if (bytes.size() < 8 || png_sig_cmp(reinterpret_cast<png_const_bytep>(bytes.data()), 0, 8) != 0) {
    throw InputError(fmt::format("\"{}\": not a PNG file", path));
  }
  try {
    const PngReader reader;
    if (!reader.info) throw std::bad_alloc();
    return decode(reader, bytes, check, visit);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& e) {
    throw InputError(fmt::format("\"{}\": damaged PNG file: {}", path, e.what()));
  }
}

}  // namespace strahl
