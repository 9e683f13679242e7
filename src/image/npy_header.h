// SPDX-License-Identifier: MIT
// The header of a NumPy .npy file.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace strahl {

struct NpyHeader {
  std::string descr;  ///< "<f8"; the text as written where it is not a string (a structured type).
  bool fortran_order = false;
  std::vector<std::size_t> shape;
  std::size_t size = 0;  ///< Bytes before the data.
};

/// Throws InputError that begins with `path`.
[[nodiscard]] NpyHeader parse_npy_header(std::string_view bytes, const std::string& path);

/// Format version 1: little-endian float64 in C order, rows x columns; its size is a multiple of 64.
[[nodiscard]] std::string npy_header_text(std::size_t rows, std::size_t columns);

}  // namespace strahl
