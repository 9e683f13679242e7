// SPDX-License-Identifier: MIT
// Rays and hits as rows of a NumPy matrix; docs/cli.md has the table of columns.
#include "cli/ray_matrix.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "errors.h"

namespace strahl::cli {
namespace {

int id_of(double value, const std::string& path, std::size_t row, const char* column) {
  const bool is_id = value >= -1 && value <= std::numeric_limits<int>::max() && value == std::floor(value);
  if (!is_id)
    throw InputError(
        fmt::format("{}: row {}: {} is {}, but must be a whole number, -1 for none", path, row, column, value));
  return static_cast<int>(value);
}

}  // namespace

std::vector<Ray> rays_of(const Matrix& matrix, const std::string& path) {
  if (matrix.columns != 8 && matrix.columns != 11)
    throw InputError(fmt::format(
        "{}: {} columns; rays have 8 (origin x y z, direction x y z, t_min, t_max) or 11 (and the instance, shape, "
        "primitive just left)",
        path, matrix.columns));
  std::vector<Ray> rays(matrix.rows);
  for (std::size_t row = 0; row < matrix.rows; ++row) {
    const double* r = &matrix.data[row * matrix.columns];
    Ray& ray = rays[row];
    ray.origin = {r[0], r[1], r[2]};
    ray.direction = {r[3], r[4], r[5]};
    ray.t_min = r[6];
    ray.t_max = r[7];
    if (matrix.columns == 8) continue;
    ray.instance = id_of(r[8], path, row, "instance");
    ray.shape = id_of(r[9], path, row, "shape");
    ray.primitive = id_of(r[10], path, row, "primitive");
  }
  return rays;
}

Matrix matrix_of(const std::vector<Hit>& hits) {
  Matrix matrix{hits.size(), 9, {}};
  matrix.data.reserve(hits.size() * matrix.columns);
  for (const Hit& hit : hits) {
    const auto id = [](int value) { return static_cast<double>(value); };
    matrix.data.insert(matrix.data.end(), {hit.t, id(hit.instance), id(hit.shape), id(hit.primitive), hit.u, hit.v,
                                           hit.normal.x, hit.normal.y, hit.normal.z});
  }
  return matrix;
}

}  // namespace strahl::cli
