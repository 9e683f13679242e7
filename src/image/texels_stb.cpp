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
