// SPDX-License-Identifier: MIT
// A PNG file's integers as they stand in it, before any curve.
#pragma once

#include <png.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace strahl {

/// Palettes and fewer than 8 bits are expanded.
struct PngCodes {
  int width = 0, height = 0;
  std::size_t channels = 0;     ///< Grey, grey and alpha, rgb, rgb and alpha.
  bool is_wide = false;         ///< 16 bits, else 8.
  std::vector<png_byte> bytes;  ///< Of 16 bits the high one first.

  [[nodiscard]] std::size_t code(std::size_t i) const {
    return is_wide ? bytes[2 * i] * 256U + bytes[2 * i + 1] : bytes[i];
  }
};

/// What is known before the pixels are unpacked; may throw.
using PngCheck = std::function<void(int width, int height, std::size_t channels, std::size_t file_bytes)>;
/// What else the file says.
using PngVisit = std::function<void(png_structp png, png_infop info)>;

/// Throws InputError.
[[nodiscard]] PngCodes read_png_codes(const std::string& path, const std::string& bytes, const PngCheck& check,
                                      const PngVisit& visit = {});

}  // namespace strahl
