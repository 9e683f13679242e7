// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace strahl {

/// An axis-aligned box: lo x, hi x, lo y, hi y, lo z, hi z.
template <typename Real>
using Bounds = std::array<Real, 6>;

/// Holds nothing; what is included first is the box then.
template <typename Real>
[[nodiscard]] Bounds<Real> empty_bounds() {
  constexpr Real most = std::numeric_limits<Real>::max();
  return {most, -most, most, -most, most, -most};
}

/// Makes `box` as large as to hold `other`, too.
template <typename Real>
void include(Bounds<Real>& box, const Bounds<Real>& other) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box[2 * axis] = std::min(box[2 * axis], other[2 * axis]);
    box[2 * axis + 1] = std::max(box[2 * axis + 1], other[2 * axis + 1]);
  }
}

}  // namespace strahl
