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

#include <cstdint>
#include <limits>
#include <memory>

#include "errors.h"
#include "image/texels_files.h"

namespace strahl {
namespace {

template <class Value>
using Pixels = std::unique_ptr<Value, void (*)(void*)>;

const stbi_uc* data_of(const std::string& bytes) { return reinterpret_cast<const stbi_uc*>(bytes.data()); }

int size_of(const std::string& bytes) {
  constexpr auto most = static_cast<std::size_t>(std::numeric_limits<int>::max());
  return bytes.size() > most ? 0 : static_cast<int>(bytes.size());
}

/// What a byte stands for at the most: runs of 128 in TGA and HDR. stb_image takes zeros for all that a file has not,
/// so that a few bytes could take seconds and a gigabyte.
constexpr std::int64_t most_texels_a_byte = 128;

void check_bytes(const std::string& path, const std::string& bytes, int width, int height) {
  const auto texels = static_cast<std::int64_t>(width) * height;
  if (texels / most_texels_a_byte <= static_cast<std::int64_t>(bytes.size())) return;
  throw InputError(
      fmt::format("\"{}\": not a readable image: {} bytes are too few for its {} x {} texels; is it cut off?", path,
                  bytes.size(), width, height));
}

}  // namespace

bool is_stb_image(const std::string& bytes) {
  int width = 0, height = 0, channels = 0;
  return stbi_info_from_memory(data_of(bytes), size_of(bytes), &width, &height, &channels) != 0;
}

Texels read_stb_texels(const std::string& path, const std::string& bytes) {
  const auto fail = [&] {
    throw InputError(fmt::format("\"{}\": not a readable image: {}", path, stbi_failure_reason()));
  };
  int width = 0, height = 0, channels = 0;
  if (stbi_info_from_memory(data_of(bytes), size_of(bytes), &width, &height, &channels) == 0) fail();
  check_texel_count(path, width, height);
  check_bytes(path, bytes, width, height);
  if (stbi_is_hdr_from_memory(data_of(bytes), size_of(bytes)) != 0) {
    const Pixels<float> values(stbi_loadf_from_memory(data_of(bytes), size_of(bytes), &width, &height, &channels, 3),
                               stbi_image_free);
    if (!values) fail();
    return texels_of_rgbe(width, height, values.get());
  }
  const int wanted = channels <= 2 ? 1 : 3;
  const Pixels<stbi_uc> codes(stbi_load_from_memory(data_of(bytes), size_of(bytes), &width, &height, &channels, wanted),
                              stbi_image_free);
  if (!codes) fail();
  return texels_of_bytes(width, height, wanted, codes.get());
}

}  // namespace strahl
