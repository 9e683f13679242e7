// SPDX-License-Identifier: MIT
// Parts of the boxes around primitives that several kinds share, in double. packing/primitive_bounds.cpp rounds them
// outwards to the device's numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "kinds/bounds.h"

namespace strahl::kinds {

inline Bounds<double> around_corners(const double* corners, int count) {
  Bounds<double> box{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box[2 * axis] = box[2 * axis + 1] = corners[axis];
    for (int i = 1; i < count; ++i) {
      const double x = corners[static_cast<std::size_t>(3 * i) + axis];
      box[2 * axis] = std::min(box[2 * axis], x);
      box[2 * axis + 1] = std::max(box[2 * axis + 1], x);
    }
  }
  return box;
}

/// lo - by ... hi + by, and one number farther outwards, which covers the roundings of the difference and of `by`.
inline void widen(Bounds<double>& box, std::size_t axis, double lo, double hi, double by) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  box[2 * axis] = std::nextafter(lo - by, -infinite);
  box[2 * axis + 1] = std::nextafter(hi + by, infinite);
}

/// How far a circle reaches along an axis: r sqrt(1 - n_i^2 / n.n), from the other two components, and a little more
/// than double rounds.
inline double reach_of_circle(double radius, double n_i, double n_j, double n_k) {
  const double across = std::hypot(n_j, n_k), all = std::hypot(n_i, across);
  return all > 0 ? radius * (across / all) * (1 + 0x1p-48) : radius;
}

}  // namespace strahl::kinds
