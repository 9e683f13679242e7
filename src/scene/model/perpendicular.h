// SPDX-License-Identifier: MIT
// A direction held at a right angle to another.
#pragma once

#include "scene/model/vec.h"

namespace strahl {

/// The unit vector nearest to v that is perpendicular to the unit vector n; where v is nearly along n, any.
[[nodiscard]] inline Vec3 perpendicular(const Vec3& v, const Vec3& n) {
  const Vec3 across = v - dot(v, n) * n;
  // Of a shorter rest too few digits are left.
  return length(across) < 0x1p-8 * length(v) ? orthonormal_basis(n)[0] : normalized(across);
}

}  // namespace strahl
