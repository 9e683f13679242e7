// SPDX-License-Identifier: MIT
// One tier a unit: the headers' guards forbid two.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "selftest/nearest.h"

#define REAL_BITS 64

namespace strahl_double {
#include "selftest/nearest_body.h"
}

namespace strahl::test {

Nearest nearest_double(std::string_view kind, std::span<const double> planes, std::span<const double> ray, int left) {
  return strahl_double::nearest_of(kind, planes, ray, left);
}

}  // namespace strahl::test
