// SPDX-License-Identifier: MIT
// Rays and hits as rows of a NumPy matrix.
#pragma once

#include <string>
#include <vector>

#include "image/npy.h"
#include "render/intersector.h"

namespace strahl::cli {

/// Rows of 8 (origin, direction, t_min, t_max) or 11 (and the instance, shape, primitive just left, -1: none). Throws
/// InputError that names `path` and the row: another number of columns, ids that are no whole numbers >= -1.
[[nodiscard]] std::vector<Ray> rays_of(const Matrix& matrix, const std::string& path);

/// Rows of 9: t, instance, shape, primitive, u, v, normal.
[[nodiscard]] Matrix matrix_of(const std::vector<Hit>& hits);

}  // namespace strahl::cli
