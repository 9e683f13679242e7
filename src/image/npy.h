// SPDX-License-Identifier: MIT
// NumPy .npy files (format versions 1-3) of float32 / float64 matrices, C or Fortran order, little-endian.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace strahl {

/// rows x columns doubles, row-major. float32 input is widened.
struct Matrix {
  std::size_t rows = 0;
  std::size_t columns = 0;
  std::vector<double> data;
};

/// Throws InputError (not an npy file, wrong dtype, not two-dimensional, truncated, ...).
[[nodiscard]] Matrix read_npy(const std::string& path);
/// float64, C order; written to a temporary name and renamed.
void write_npy(const Matrix& matrix, const std::string& path);

}  // namespace strahl
