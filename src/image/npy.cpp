// SPDX-License-Identifier: MIT
// NumPy matrices: the file in one read, the numbers in one pass. The header is npy_header.h's.
#include "image/npy.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "errors.h"
#include "image/atomic_file.h"
#include "image/byte_order.h"
#include "image/file_bytes.h"
#include "image/npy_header.h"

namespace strahl {
namespace {

std::string remedy_for_shape(const std::vector<std::size_t>& shape) {
  if (shape.size() == 1) return "; a single row is array.reshape(1, -1), many are array.reshape(-1, columns)";
  return "; make it one with array.reshape(-1, columns)";
}

/// True where rows * columns * item bytes are exactly `bytes`, without the overflow of a product.
bool fills(std::size_t rows, std::size_t columns, std::size_t item, std::size_t bytes) {
  if (rows == 0 || columns == 0) return bytes == 0;
  return bytes % item == 0 && bytes / item % columns == 0 && bytes / item / columns == rows;
}

template <class T>
void widen(const char* bytes, std::endian order, bool fortran_order, Matrix& matrix) {
  double* out = matrix.data.data();
  if (matrix.data.empty()) return;  // A header may state any number of rows that have no columns.
  if (!fortran_order) {
    for (std::size_t i = 0; i < matrix.data.size(); ++i) out[i] = load<T>(bytes + i * sizeof(T), order);
    return;
  }
  for (std::size_t row = 0; row < matrix.rows; ++row) {
    for (std::size_t column = 0; column < matrix.columns; ++column) {
      *out++ = load<T>(bytes + (column * matrix.rows + row) * sizeof(T), order);
    }
  }
}

}  // namespace

Matrix read_npy(const std::string& path) {
  const std::string bytes = read_file(path);
  const NpyHeader header = parse_npy_header(bytes, path);
  const bool is_single = header.descr == "<f4" || header.descr == ">f4";
  if (!is_single && header.descr != "<f8" && header.descr != ">f8") {
    throw InputError(fmt::format("\"{}\": values of type {}, not float32 or float64; convert with array.astype('f8')",
                                 path, header.descr));
  }
  if (header.shape.size() != 2) {
    throw InputError(fmt::format("\"{}\": an array of shape ({}), not a matrix{}", path, fmt::join(header.shape, ", "),
                                 remedy_for_shape(header.shape)));
  }
  Matrix matrix;
  matrix.rows = header.shape[0];
  matrix.columns = header.shape[1];
  const std::size_t available = bytes.size() - header.size;
  const std::size_t item = is_single ? sizeof(float) : sizeof(double);
  if (!fills(matrix.rows, matrix.columns, item, available)) {
    throw InputError(fmt::format("\"{}\": {} bytes of data do not fit {} x {} values of {} bytes: truncated or damaged",
                                 path, available, matrix.rows, matrix.columns, item));
  }
  matrix.data.resize(available / item);
  const std::endian order = header.descr[0] == '<' ? std::endian::little : std::endian::big;
  const char* data = bytes.data() + header.size;
  if (is_single) {
    widen<float>(data, order, header.fortran_order, matrix);
  } else {
    widen<double>(data, order, header.fortran_order, matrix);
  }
  return matrix;
}

void write_npy(const Matrix& matrix, const std::string& path) {
  if (!fills(matrix.rows, matrix.columns, 1, matrix.data.size())) {
    throw Error(fmt::format("a matrix of {} x {} values has {}", matrix.rows, matrix.columns, matrix.data.size()));
  }
  AtomicFile file(path);
  file.write(npy_header_text(matrix.rows, matrix.columns));
  file.write(little_endian_bytes(matrix.data));
  file.commit();
}

}  // namespace strahl
