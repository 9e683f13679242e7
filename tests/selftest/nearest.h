// SPDX-License-Identifier: MIT
// Bodies of cl/shapes compiled for the host, one lane: the nearest of several primitives of one kind.
#pragma once

#include <span>
#include <string_view>

namespace strahl::test {

struct Nearest {
  double t;       ///< In units of the direction as given, infinite for a miss.
  int primitive;  ///< -1 for a miss.
};

/// planes: primitive after primitive; ray: RAY_REALS of cl/scene/layout.h; left: index or -1.
[[nodiscard]] Nearest nearest_stable(std::string_view kind, std::span<const double> planes, std::span<const double> ray,
                                     int left);
[[nodiscard]] Nearest nearest_robust(std::string_view kind, std::span<const double> planes, std::span<const double> ray,
                                     int left);
[[nodiscard]] Nearest nearest_double(std::string_view kind, std::span<const double> planes, std::span<const double> ray,
                                     int left);

}  // namespace strahl::test
