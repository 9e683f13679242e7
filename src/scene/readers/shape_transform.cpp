// SPDX-License-Identifier: MIT
// Does a transform keep circles round?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/readers/shape_reader.h"

namespace strahl {

bool are_equally_long(const Vec3& a, const Vec3& b) {
  const double la = length(a), lb = length(b);
  return std::abs(la - lb) <= shape_tolerance * std::max(la, lb);
}

bool are_perpendicular(const Vec3& a, const Vec3& b) {
  return std::abs(dot(normalized(a), normalized(b))) <= shape_tolerance;
}

void report_distortion(const ShapeInput& input, const char* remedy) {
  input.builder.diagnostics.error(input.properties.where("to_world"),
                                  fmt::format("to_world distorts {}: {}", input.properties.title(), remedy));
}

}  // namespace strahl
