// SPDX-License-Identifier: MIT
// cl/math/soft_fma.h against the machine's fma, which glibc and IEEE 754 say is rounded once: the same bits, whatever
// the operands.
#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "cl/math_tiers.h"

using strahl::test::soft_fma;

namespace {

class Draw {
 public:
  /// Any bits: denormal numbers, infinities and NaN too.
  float any() { return std::bit_cast<float>(static_cast<std::uint32_t>(bits_())); }
  int integer(int least, int most) { return std::uniform_int_distribution(least, most)(bits_); }
  /// The significant digits all but `digits` of the first cleared, the exponent's field as given.
  float of(int field, int digits = 24) {
    const auto sign_and_rest = static_cast<std::uint32_t>(bits_()) & 0x807fffffu & ~((1u << (24 - digits)) - 1);
    return std::bit_cast<float>(sign_and_rest | static_cast<std::uint32_t>(std::clamp(field, 0, 254)) << 23);
  }

 private:
  std::mt19937_64 bits_{35};
};

int field_of(float x) { return static_cast<int>(std::bit_cast<std::uint32_t>(x) >> 23 & 255u); }

/// How often the result was rounded, was denormal, was endless or NaN.
struct Seen {
  int rounded = 0, denormal = 0, endless = 0;
};

void check(float a, float b, float c, Seen& seen) {
  const float expected = std::fma(a, b, c), got = soft_fma(a, b, c);
  seen.rounded +=
      static_cast<double>(expected) != static_cast<double>(a) * static_cast<double>(b) + static_cast<double>(c);
  seen.denormal += std::fpclassify(expected) == FP_SUBNORMAL;
  seen.endless += !std::isfinite(expected);
  if (std::isnan(expected) ? std::isnan(got)
                           : std::bit_cast<std::uint32_t>(expected) == std::bit_cast<std::uint32_t>(got))
    return;
  INFO(std::hexfloat << a << " * " << b << " + " << c << " is " << got << ", not " << expected);
  FAIL();
}

}  // namespace

TEST_CASE("fma in integers has the bits of the machine's") {
  Draw draw;
  constexpr int times = 300000;
  Seen seen;
  for (int i = 0; i < times; ++i) check(draw.any(), draw.any(), draw.any(), seen);
  CHECK(seen.endless > 1000);

  SECTION("where sums cancel, to the last digits of the product") {
    seen = {};
    for (int i = 0; i < times; ++i) {
      const float a = draw.of(draw.integer(60, 190)), b = draw.of(draw.integer(60, 190));
      const float product = a * b;
      check(a, b, -product, seen);
      const auto away = static_cast<std::uint32_t>(draw.integer(-8, 8));
      check(a, b, std::bit_cast<float>(std::bit_cast<std::uint32_t>(-product) + away), seen);
    }
    CHECK(seen.denormal > 1000);
  }
  SECTION("where numbers are short, so that sums lie in the middle of two") {
    seen = {};
    for (int i = 0; i < times; ++i) {
      const float a = draw.of(draw.integer(90, 160), draw.integer(1, 13)), b = draw.of(draw.integer(90, 160), 12);
      check(a, b, draw.of(field_of(a * b) + draw.integer(-30, 30), draw.integer(1, 4)), seen);
    }
    CHECK(seen.rounded > times / 10);
  }
  SECTION("near and below the least normal number") {
    seen = {};
    for (int i = 0; i < times; ++i) {
      const int field = draw.integer(0, 127);
      check(draw.of(field), draw.of(127 - field + draw.integer(-30, 10)), draw.of(draw.integer(0, 8)), seen);
      check(draw.of(field), draw.of(127 - field + draw.integer(-30, 10)), draw.of(0, draw.integer(1, 24)), seen);
    }
    CHECK(seen.denormal > times / 2);
  }
  SECTION("near the largest number") {
    seen = {};
    for (int i = 0; i < times; ++i) {
      const int field = draw.integer(127, 254);
      check(draw.of(field), draw.of(381 - field + draw.integer(-3, 1)), draw.of(draw.integer(250, 254)), seen);
    }
    CHECK(seen.endless > times / 10);
  }
  SECTION("zeros, ones, the largest and the least numbers, infinities and NaN, with either sign") {
    const float numbers[] = {0, 1, 0x1p-149f, 0x1p-126f, 0x1.fffffep-127f, 0x1.fffffep127f, INFINITY, NAN, 3};
    for (const float a : numbers)
      for (const float b : numbers)
        for (const float c : numbers)
          for (int signs = 0; signs < 8; ++signs)
            check(signs & 1 ? -a : a, signs & 2 ? -b : b, signs & 4 ? -c : c, seen);
  }
}
