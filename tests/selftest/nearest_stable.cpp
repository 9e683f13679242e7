// SPDX-License-Identifier: MIT
// One tier a unit: the headers' guards forbid two.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "selftest/nearest.h"

#define REAL_BITS 32
namespace strahl_stable {
#include "selftest/nearest_body.h"
}

namespace strahl::test {

Nearest nearest_stable(std::string_view kind, std::span<const double> planes, std::span<const double> ray, int left) {
  return strahl_stable::nearest_of(kind, planes, ray, left);
}

}  // namespace strahl::test
