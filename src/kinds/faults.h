// SPDX-License-Identifier: MIT
// What is wrong with the numbers of a shape or a light: a sentence for each invariant of scene.h that it breaks. The
// tolerance for frames covers the rounding of a chain of a few operations in double.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "scene/model/vec.h"

namespace strahl::kinds {

inline constexpr double frame_tolerance = 0x1p-40;  // some thousand roundings of 2^-53: no chain of rotations is longer

inline bool is_zero(double x) { return std::abs(x) <= frame_tolerance; }
inline bool is_unit(const Vec3& v) { return is_zero(length(v) - 1); }
inline bool is_degenerate(const Vec3& a, const Vec3& b) { return cross(a, b) == Vec3{}; }

class Faults {
 public:
  template <typename... Values>
  void require(bool holds, fmt::format_string<Values...> fault, Values&&... values) {
    if (!holds) faults_.push_back(fmt::format(fault, std::forward<Values>(values)...));
  }
  void require_radius(double radius) {
    require(std::isfinite(radius) && radius > 0, "the radius is {}; it must be finite and > 0", radius);
  }
  void require_orthonormal(const std::array<Vec3, 3>& frame) {
    const auto& [x, y, z] = frame;
    require(is_unit(x) && is_unit(y) && is_unit(z) && is_zero(dot(x, y)) && is_zero(dot(y, z)) && is_zero(dot(z, x)),
            "the sphere's frame must be orthonormal");
  }

  [[nodiscard]] std::vector<std::string> take() { return std::move(faults_); }

 private:
  std::vector<std::string> faults_;
};

}  // namespace strahl::kinds
