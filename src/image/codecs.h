// SPDX-License-Identifier: MIT
// What image_io.h promises, one function a format; image_io.cpp and texels_read.cpp alone call these.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "image/image.h"
#include "image/image_io.h"

namespace strahl {

WriteReport write_png(const Image& image, const std::string& path, const PngOptions& options);
WriteReport write_exr(const Image& image, const std::string& path);
WriteReport write_pfm(const Image& image, const std::string& path);

/// Of a file's bytes; the path is for messages.
[[nodiscard]] Image read_png(const std::string& path, const std::string& bytes);
[[nodiscard]] Image read_pfm(const std::string& path, const std::string& bytes);
/// The display window, with the numbers that the file has.
[[nodiscard]] Image read_exr(const std::string& path, const std::string& bytes);
struct ExrTexture {
  Image image;
  int parts = 1;  ///< Of the file; the image is the first.
};
/// The data window, as Mitsuba 3 takes it for textures; colours of Rec. 709, also from X, Y and Z and from other
/// primaries. Names of channels in lower case are those in upper case.
[[nodiscard]] ExrTexture read_exr_texture(const std::string& path, const std::string& bytes);

/// The most values that a file may claim.
struct ClaimLimit {
  std::size_t always = 0;    ///< Are no danger, whatever the file.
  std::size_t per_byte = 0;  ///< Of the file.
};
/// 256 MiB, and more than the best compression reaches (OpenEXR's DWA of one constant).
constexpr ClaimLimit compressed_values = {std::size_t{1} << 26, 65536};

/// Throws InputError for sizes that no file of so many bytes can hold, before memory for them is asked for: a damaged
/// header must not end in an exhausted computer.
void check_picture_size(const std::string& path, std::int64_t width, std::int64_t height, std::size_t channels,
                        std::size_t file_bytes, const ClaimLimit& claim = compressed_values);

}  // namespace strahl
