// SPDX-License-Identifier: MIT
// Numbers as a device of 32 bits holds them.
#pragma once

#include "scene/model/vec.h"

namespace strahl::selftest {

/// Unit roundoff of float.
inline constexpr double u = 0x1p-24;

/// Rounded to float. volatile: g++ 12.2 drops the rounding when it vectorises neighbouring components.
[[nodiscard]] inline double to_float(double x) {
  const volatile float narrow = static_cast<float>(x);
  return static_cast<double>(narrow);
}

[[nodiscard]] inline Vec3 to_float(const Vec3& v) { return {to_float(v.x), to_float(v.y), to_float(v.z)}; }

}  // namespace strahl::selftest
