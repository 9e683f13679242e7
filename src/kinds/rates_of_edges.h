// SPDX-License-Identifier: MIT
// How fast the weights of two edges change over the parallelogram that they span.
#pragma once

#include "scene/model/vec.h"

namespace strahl::kinds {

/// One over the parallelogram's heights; zero where it has no area.
inline Vec2 rates_of_edges(const Vec3& u, const Vec3& v) {
  const double area = length(cross(u, v));
  return area > 0 ? Vec2{length(v) / area, length(u) / area} : Vec2{};
}

}  // namespace strahl::kinds
