// SPDX-License-Identifier: MIT
// Does a transform keep circles round?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/readers/shape_reader.h"

namespace strahl {

double unlike_lengths(const Vec3& a, const Vec3& b) {
  const double la = length(a), lb = length(b);
  return std::abs(la - lb) / std::max(la, lb);
}

double off_right_angle(const Vec3& a, const Vec3& b) { return std::abs(dot(normalized(a), normalized(b))); }

bool keeps_round(const ShapeInput& input, double deviation) {
  if (deviation <= shape_tolerance) return true;
  if (!(deviation <= widest_shape_tolerance)) return false;
  input.builder.diagnostics.warning(
      input.properties.where("to_world"),
      fmt::format("to_world distorts {} by a share of {:.1g}, as rounded numbers do; it stays round",
                  input.properties.title(), deviation));
  return true;
}

void report_distortion(const ShapeInput& input, const char* remedy) {
  input.builder.diagnostics.error(input.properties.where("to_world"),
                                  fmt::format("to_world distorts {}: {}", input.properties.title(), remedy));
}

}  // namespace strahl
