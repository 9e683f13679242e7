// SPDX-License-Identifier: MIT
// Radiance HDR, TGA and BMP by S. Barrett's stb_image, of which no other part is compiled.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_HDR
#define STBI_ONLY_TGA
#define STBI_ONLY_BMP
#define STBI_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>

#include "errors.h"
#include "image/texels_files.h"

namespace strahl {
namespace {

template <class Value>
using Pixels = std::unique_ptr<Value, void (*)(void*)>;

/// A file's bytes as stb_image asks for them. It takes what it is given for all that a file has not: zeros that end no
/// loop of its HDR reader, and memory that nobody wrote. So it gets line ends instead, which end all of its loops, and
/// is_short tells.
class Source {
 public:
  explicit Source(const std::string& bytes) : bytes_(bytes) {}

  [[nodiscard]] bool is_short() const { return is_short_; }

  /// From the start.
  template <typename Read>
  auto operator()(const Read& read) {
    position_ = 0;
    is_short_ = false;
    const stbi_io_callbacks callbacks{
        [](void* self, char* data, int size) { return static_cast<Source*>(self)->take(data, size); },
        [](void* self, int size) { static_cast<Source*>(self)->skip(size); },
        [](void* self) { return static_cast<Source*>(self)->left() == 0 ? 1 : 0; }};
    return read(&callbacks, this);
  }

 private:
  [[nodiscard]] std::size_t left() const { return bytes_.size() - position_; }

  int take(char* data, int size) {
    constexpr std::size_t buffer = sizeof(stbi__context::buffer_start);  // Filled as far as the file goes.
    const auto wanted = static_cast<std::size_t>(size);
    const std::size_t taken = std::min(wanted, left());
    std::copy_n(bytes_.data() + position_, taken, data);
    position_ += taken;
    if (taken == wanted || (taken > 0 && wanted == buffer)) return static_cast<int>(taken);
    is_short_ = true;
    std::fill_n(data + taken, wanted - taken, '\n');
    return size;
  }

  /// Padding behind the last row may be missing.
  void skip(int size) { position_ += std::min(static_cast<std::size_t>(size), left()); }

  const std::string& bytes_;
  std::size_t position_ = 0;
  bool is_short_ = false;
};

struct Header {
  int width = 0, height = 0, channels = 0;
};

std::optional<Header> header_of(Source& source) {
  Header header;
  const int is_known = source([&](auto... from) {  //
    return stbi_info_from_callbacks(from..., &header.width, &header.height, &header.channels);
  });
  if (is_known == 0 || source.is_short()) return std::nullopt;
  // Rows of a BMP from the top have a negative height.
  if (header.height < 0 && header.height != std::numeric_limits<int>::min()) header.height = -header.height;
  return header;
}

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw InputError(fmt::format("\"{}\": not a readable image: {}", path, why));
}

[[noreturn]] void refuse_cut(const std::string& path, const std::string& bytes, const Header& header) {
  refuse(path, fmt::format("{} bytes are too few for its {} x {} texels; is it cut off?", bytes.size(), header.width,
                           header.height));
}

/// What a byte stands for at the most: runs of 128 in TGA and HDR. A few bytes must not take seconds and a gigabyte.
constexpr std::int64_t most_texels_a_byte = 128;

/// What a TGA's header says beside the picture's size; of other files nothing.
struct TgaHeader {
  std::size_t plain_bytes = 0;  ///< Of a file without runs, whose rows stb_image reads without a look at how many there
                                ///< were; else 0.
  std::size_t first_colour = 0;    ///< The number of the palette's first one, which stb_image takes for bytes to skip.
  bool is_from_the_right = false;  ///< The order of columns, which stb_image does not read.
};

TgaHeader tga_header(const std::string& bytes, const Header& header) {
  constexpr std::size_t header_bytes = 18;
  TgaHeader tga;
  if (bytes.size() < header_bytes || bytes.starts_with("BM") || bytes.starts_with("#?")) return tga;
  const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i])); };
  const bool has_palette = byte(1) != 0;
  if (has_palette) tga.first_colour = byte(3) + 256 * byte(4);
  tga.is_from_the_right = (byte(17) & 0x10U) != 0;
  constexpr std::size_t first_with_runs = 8;
  if (byte(2) >= first_with_runs) return tga;
  const std::size_t palette = has_palette ? (byte(5) + 256 * byte(6)) * ((byte(7) + 7) / 8) : 0;
  const std::size_t count = static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height);
  tga.plain_bytes = header_bytes + byte(0) + palette + count * ((byte(16) + 7) / 8);
  return tga;
}

template <class Value>
void mirror_columns(Value* values, int width, int height, int channels) {
  for (std::ptrdiff_t y = 0; y < height; ++y) {
    Value* row = values + y * width * channels;
    for (std::ptrdiff_t left = 0, right = width - 1; left < right; ++left, --right)
      std::swap_ranges(row + left * channels, row + (left + 1) * channels, row + right * channels);
  }
}

/// stb_image tells the reason of the last format alone that it tried.
std::string reason_of(const std::string& bytes) {
  if (bytes.starts_with("BM"))
    return "a BMP file that is damaged or compressed; save it without compression, or as PNG";
  if (bytes.starts_with("#?"))
    return "a Radiance file is to begin with #?RADIANCE or #?RGBE, of 32-bit_rle_rgbe, with its rows from the top (-Y, "
           "+X)";
  return stbi_failure_reason();
}

}  // namespace

bool is_stb_image(const std::string& bytes) {
  Source source(bytes);
  return header_of(source).has_value();
}

Texels read_stb_texels(const std::string& path, const std::string& bytes) {
  Source source(bytes);
  const std::optional<Header> header = header_of(source);
  if (!header) refuse(path, reason_of(bytes));
  check_texel_count(path, header->width, header->height);
  const std::int64_t texels = std::int64_t{header->width} * header->height;
  const TgaHeader tga = tga_header(bytes, *header);
  if (texels / most_texels_a_byte > static_cast<std::int64_t>(bytes.size()) || tga.plain_bytes > bytes.size())
    refuse_cut(path, bytes, *header);
  if (tga.first_colour > 0)
    refuse(path, fmt::format("a TGA file whose palette begins with colour {}; save it with all colours from 0 on, or "
                             "as PNG",
                             tga.first_colour));
  const auto decode = [&](const auto& read, int channels) {
    Header decoded;
    auto* values = source(
        [&](auto... from) { return read(from..., &decoded.width, &decoded.height, &decoded.channels, channels); });
    const Pixels<std::remove_pointer_t<decltype(values)>> owner(values, stbi_image_free);
    if (source.is_short()) refuse_cut(path, bytes, *header);
    if (!values) refuse(path, stbi_failure_reason());
    if (tga.is_from_the_right) mirror_columns(values, decoded.width, decoded.height, channels);
    if constexpr (std::is_same_v<decltype(values), float*>)
      return texels_of_rgbe(decoded.width, decoded.height, values);
    else
      return texels_of_bytes(decoded.width, decoded.height, channels, values);
  };
  if (source([](auto... from) { return stbi_is_hdr_from_callbacks(from...); }) != 0)
    return decode(stbi_loadf_from_callbacks, 3);
  return decode(stbi_load_from_callbacks, header->channels <= 2 ? 1 : 3);
}

}  // namespace strahl
