// SPDX-License-Identifier: MIT
// Pictures to and from files. Every writer writes to a temporary name beside the target and renames it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "image/image.h"

namespace strahl {

enum class ImageFormat { png, exr, pfm };

/// By extension, case-insensitive; throws UsageError that lists the known ones.
[[nodiscard]] ImageFormat image_format(const std::string& path);

struct PngOptions {
  int bits = 8;         ///< 8 or 16.
  double exposure = 0;  ///< Stops: linear values are multiplied by 2^exposure before encoding.
};

/// What writing did to the values.
struct WriteReport {
  std::size_t clipped = 0;   ///< PNG: channel values above 1 (after exposure) or below 0.
  std::size_t invalid = 0;   ///< NaN or infinite values (PNG: written as 0 / 1).
  double rounding_rmse = 0;  ///< What the file's codes are off by, in the picture's linear values: within [0, 1] ...
  double clipping_rmse = 0;  ///< ... and outside of it, both over all finite values.
};

/// PNG: the picture's colour in sRGB with the metadata as text chunks. EXR: all channels as 32-bit float, ZIP, metadata
/// as string attributes. PFM: the picture's colour, little-endian, bottom row first.
/// A picture's colour are the first three channels of its first layer ("LAYER.CHANNEL"), without those named A, which
/// is alpha: one of them is grey, two are red and green beside a blue of 0. Error where there are none, and for names
/// that an EXR would cut: more than 255 bytes.
WriteReport write_image(const Image& image, const std::string& path, const PngOptions& png = {});

/// Linear floats of a PNG (sRGB decoded), EXR (all channels, any compression, half/float/uint) or PFM file.
/// Throws InputError.
[[nodiscard]] Image read_image(const std::string& path);

}  // namespace strahl
