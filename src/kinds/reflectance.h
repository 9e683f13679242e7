// SPDX-License-Identifier: MIT
#pragma once

#include "scene/model/vec.h"

namespace strahl {

/// Each channel is a share of the light, within [0, 1].
[[nodiscard]] inline bool is_reflectance(const Rgb& c) {
  const auto inside = [](double x) { return x >= 0 && x <= 1; };
  return inside(c.r) && inside(c.g) && inside(c.b);
}

}  // namespace strahl
