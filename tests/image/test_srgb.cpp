// SPDX-License-Identifier: MIT
// The sRGB curve: known values, and every code of 8 and 16 bits back to itself through a float.
#include <catch2/catch.hpp>

#include "image/srgb.h"

using namespace strahl;

TEST_CASE("known values") {
  CHECK(srgb_from_linear(0) == 0);
  CHECK(srgb_from_linear(1) == Approx(1).margin(1e-15));
  CHECK(srgb_from_linear(0.5) == Approx(0.7353569830524495).epsilon(1e-14));
  CHECK(srgb_from_linear(0.001) == Approx(0.01292).epsilon(1e-14));
  CHECK(linear_from_srgb(0.5) == Approx(0.21404114048223255).epsilon(1e-14));
  CHECK(linear_from_srgb(0.02) == Approx(0.02 / 12.92).epsilon(1e-14));
}

TEST_CASE("every code survives decoding to a float and encoding") {
  for (const int largest : {255, 65535}) {
    int wrong = 0;
    for (int code = 0; code <= largest; ++code) {
      const auto linear = static_cast<float>(linear_from_srgb(static_cast<double>(code) / largest));
      wrong += static_cast<int>(srgb_from_linear(static_cast<double>(linear)) * largest + 0.5) != code;
    }
    CHECK(wrong == 0);
  }
}
