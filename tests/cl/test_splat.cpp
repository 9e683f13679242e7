// SPDX-License-Identifier: MIT
// Splats of light paths (cl/film/splat.h) of both tiers on the host against exact rationals: a float comes back whole
// down to the lowest bin, what is cut of a double has its bound, and no piece is larger than a word holds 2^31 times.
// Device: test_splats.
#include <gmpxx.h>

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "cl/math_tiers.h"
#include "render/film_sum.h"

using namespace strahl;
using namespace strahl::test;

namespace {

using Counts = std::array<std::uint32_t, 4>;

constexpr double lowest = 0x1p-148;  ///< The lowest bin's unit.

mpq_class exact(const SplatWords& words) {
  mpq_class sum = 0, unit = lowest;
  for (const std::int64_t word : words) {
    sum += unit * mpq_class(word);
    unit *= mpq_class(0x1p32);
  }
  return sum;
}

template <class Real>
SplatWords splat_of(Real value) {
  Counts counts{};
  SplatWords words{};
  add_splat(words, value, &counts);
  CHECK(counts == Counts{});
  for (const std::int64_t word : words) REQUIRE(std::abs(word) < std::int64_t{1} << 32);
  return words;
}

/// At every border of a bin, from both sides, the smallest and the largest; then any bits.
std::vector<float> floats() {
  std::vector<float> values{0.0F, 0x1p-149F, 0x1p-148F, 0x1.8p-148F, 0x1.fffffcp-127F, 0x1p-126F, 0x1.fffffep127F};
  for (int bin = 1; bin < 9; ++bin)
    for (const float size : {1.0F, 0x1.fffffep-1F, 0x1.000002p0F, 0x1.fffffep0F})
      values.push_back(std::ldexp(size, 32 * bin - 148));
  std::mt19937 random(5);
  while (values.size() < 200000) {
    const auto value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (std::isfinite(value)) values.push_back(std::fabs(value));
  }
  return values;
}

}  // namespace

TEST_CASE("a float comes back whole down to 2^-148, of either sign") {
  for (const float value : floats())
    for (const float sign : {1.0F, -1.0F}) {
      const double kept = std::trunc(static_cast<double>(value) / lowest) * lowest * static_cast<double>(sign);
      const SplatWords words = splat_of(sign * value);
      if (exact(words) != mpq_class(kept) || value_of_splats(words.data()) != kept) {
        CAPTURE(value, sign, words);
        FAIL("not whole");
      }
    }
}

TEST_CASE("the same from either tier") {
  for (const float value : floats()) REQUIRE(splat_of(value) == splat_of(static_cast<double>(value)));
}

TEST_CASE("of a double the 33 leading bits stay, cut towards 0 and at 2^-148") {
  std::mt19937_64 random(5);
  for (int i = 0; i < 200000; ++i) {
    const std::uint64_t exponent = 1023 - 152 + random() % 280;
    const auto value = std::bit_cast<double>((random() >> 12) | exponent << 52 | (random() & 1) << 63);
    if (std::fabs(value) > static_cast<double>(std::numeric_limits<float>::max())) continue;
    const mpq_class held = exact(splat_of(value)), size = abs(mpq_class(value)), lost = size - abs(held);
    const bool is_of_its_sign = held == 0 || sgn(held) == (value < 0 ? -1 : 1);
    if (!is_of_its_sign || lost < 0 || (lost >= size * mpq_class(0x1p-32) && lost >= mpq_class(lowest))) {
      CAPTURE(value, held.get_d());
      FAIL("cut off too much");
    }
  }
}

TEMPLATE_TEST_CASE("2^31 of the largest pieces fit, of either sign", "", float, double) {
  for (int power = -148; power < 128; ++power) {
    const TestType ones = std::ldexp(std::nextafter(TestType(2), TestType(0)), power);
    if (!(static_cast<double>(ones) <= static_cast<double>(std::numeric_limits<float>::max()))) continue;
    for (const TestType value : {ones, -ones})
      for (const std::int64_t word : splat_of(value)) {
        std::int64_t all = 0;
        CHECK_FALSE(__builtin_mul_overflow(word, std::int64_t{1} << 31, &all));
      }
  }
}

TEMPLATE_TEST_CASE("NaN adds nothing, what is beyond a float adds the largest, and both are told", "", float, double) {
  using Limits = std::numeric_limits<TestType>;
  constexpr double most = std::numeric_limits<float>::max();
  Counts counts{};
  SplatWords words{};
  add_splat(words, Limits::quiet_NaN(), &counts);
  CHECK(words == SplatWords{});
  CHECK(counts == Counts{0, 1, 0, 0});
  add_splat(words, Limits::infinity(), &counts);
  CHECK(value_of_splats(words.data()) == most);
  add_splat(words, -Limits::infinity(), &counts);
  CHECK(exact(words) == 0);
  CHECK(counts == Counts{2, 1, 0, 0});
}
