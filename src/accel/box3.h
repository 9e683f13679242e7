// SPDX-License-Identifier: MIT
// Axis-aligned boxes in single precision, four floats a corner so that the compiler takes a register for each: what the
// builder weighs and sorts. The fourth floats are free for the owner's use.
#pragma once

#include <algorithm>
#include <limits>

namespace strahl::accel {

typedef float Float4 __attribute__((vector_size(16)));
typedef int Int4 __attribute__((vector_size(16)));

[[nodiscard]] inline Float4 min4(Float4 a, Float4 b) { return a < b ? a : b; }
[[nodiscard]] inline Float4 max4(Float4 a, Float4 b) { return a > b ? a : b; }

struct Box3 {
  Float4 lo, hi;

  [[nodiscard]] static Box3 empty() {
    constexpr float big = std::numeric_limits<float>::max();
    return {Float4{big, big, big, big}, Float4{-big, -big, -big, -big}};
  }
  void include(const Box3& other) {
    lo = min4(lo, other.lo);
    hi = max4(hi, other.hi);
  }
  void include(Float4 point) {
    lo = min4(lo, point);
    hi = max4(hi, point);
  }
  /// Half the surface, which is what ratios need; 0 for an empty box.
  [[nodiscard]] float half_area() const {
    const Float4 d = hi - lo;
    return d[0] < 0 ? 0.0F : d[0] * (d[1] + d[2]) + d[1] * d[2];
  }
};

}  // namespace strahl::accel
