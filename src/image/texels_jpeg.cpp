// SPDX-License-Identifier: MIT
// JPEG by libjpeg-turbo, baseline and progressive: 8 bits, grey or rgb.
#include <fmt/format.h>
#include <turbojpeg.h>

#include <memory>
#include <string_view>
#include <vector>

#include "errors.h"
#include "image/texels_files.h"

namespace strahl {

Texels read_jpeg_texels(const std::string& path, const std::string& bytes) {
  const std::unique_ptr<void, int (*)(tjhandle)> jpeg(tjInitDecompress(), tjDestroy);
  if (!jpeg) throw std::bad_alloc();
  const auto reason = [&] { return std::string_view(tjGetErrorStr2(jpeg.get())); };
  const auto fail = [&] {
    throw InputError(
        fmt::format("\"{}\": JPEG file damaged or of a rare kind ({}); save it anew, or as PNG", path, reason()));
  };
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  const auto size = static_cast<unsigned long>(bytes.size());
  int width = 0, height = 0, subsampling = 0, colours = 0;
  if (tjDecompressHeader3(jpeg.get(), data, size, &width, &height, &subsampling, &colours) != 0) fail();
  check_texel_count(path, width, height);
  if (colours == TJCS_CMYK || colours == TJCS_YCCK)
    throw InputError(fmt::format("\"{}\": a JPEG file of inks (CMYK); convert it to RGB", path));
  const bool is_grey = colours == TJCS_GRAY;
  const int channels = is_grey ? 1 : 3;
  std::vector<std::uint8_t> codes(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                                  static_cast<std::size_t>(channels));
  // Without the limit (500) a small file of empty scans over a large picture would take hours.
  const int fault = tjDecompress2(jpeg.get(), data, size, codes.data(), width, 0, height,
                                  is_grey ? TJPF_GRAY : TJPF_RGB, TJFLAG_ACCURATEDCT | TJFLAG_LIMITSCANS);
  // A warning is damage too: a part of the picture would be grey. But some cameras leave bytes before the end.
  const bool has_rest = fault != 0 && reason().find("extraneous bytes before marker 0xd9") != std::string_view::npos;
  if (fault != 0 && !has_rest) fail();
  Texels texels = texels_of_bytes(width, height, channels, codes.data());
  if (has_rest) texels.doubt = reason();
  return texels;
}

}  // namespace strahl
