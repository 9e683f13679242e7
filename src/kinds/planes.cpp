// SPDX-License-Identifier: MIT
#include "kinds/planes.h"

#include <algorithm>
#include <cmath>

namespace strahl::kinds {

Vec3 near_unit(const Vec3& normal) {
  const double size = std::max({std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)});
  if (!(size > 0) || !std::isfinite(size)) return normal;
  // Component by component: the power itself overflows where the size is subnormal.
  const int exponent = -std::ilogb(size);
  return {std::scalbn(normal.x, exponent), std::scalbn(normal.y, exponent), std::scalbn(normal.z, exponent)};
}

}  // namespace strahl::kinds
