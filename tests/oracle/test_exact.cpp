// SPDX-License-Identifier: MIT
// The ulp measure, the filter's error bound, the 200-bit path.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "oracle/exact.h"
#include "oracle/number.h"
#include "oracle/quadratic.h"
#include "oracle/random.h"

using namespace strahl::oracle;

TEST_CASE("an ulp error counts spacings of the exact value's binade") {
  CHECK(ulp_error_f32(1.5f, {1.5, 0}) == 0);
  CHECK(ulp_error_f32(1.5f, {1.5 + 0x1p-23, 0}) == 1);
  CHECK(ulp_error_f32(1.5f, {1.5 + 0x1p-25, 0}) == 0.25);
  CHECK(ulp_error_f64(1.5, {1.5, 0x1p-54}) == 0.25);
  CHECK(ulp_error_f64(-3.0, {-3.0 - 0x1p-51, 0}) == 1);
}

TEST_CASE("at a power of two the finer binade counts unless the exact value lies above it") {
  CHECK(ulp_error_f32(1.0f + 0x1p-23f, {1.0, 0}) == 2);
  CHECK(ulp_error_f64(1.0 + 0x1p-52, {1.0, -0x1p-60}) == Approx(2).epsilon(0.01));
  CHECK(ulp_error_f64(1.0 + 0x1p-52, {1.0, 0x1p-60}) == Approx(1).epsilon(0.01));
}

TEST_CASE("the ulp below the normal range is that of the subnormals") {
  CHECK(ulp_error_f32(0x1p-149f, {0, 0}) == 1);
  CHECK(ulp_error_f32(0x1p-149f, {0x1p-150, 0}) == 0.5);
  CHECK(ulp_error_f64(0x1p-1074, {0, 0}) == 1);
  CHECK(ulp_error_f32(0, {1e-300, 0}) < 1e-200);
}

TEST_CASE("infinity stands for the first number out of range, NaN is infinitely wrong") {
  const float infinity = std::numeric_limits<float>::infinity();
  CHECK(ulp_error_f32(infinity, {0x1p128, 0}) == 0);
  CHECK(ulp_error_f32(infinity, {1e300, 0}) == 0);
  CHECK(ulp_error_f32(-infinity, {1e300, 0}) > 1e6);
  CHECK(ulp_error_f32(infinity, {0x1.fffffep127, 0}) == 1);
  CHECK(std::isinf(ulp_error_f32(NAN, {1, 0})));
}

TEST_CASE("the gap to a bound is relative, and exact beyond double") {
  CHECK(relative_gap({2, 0}, 1) == 0.5);
  CHECK(relative_gap({0, 0}, 0) == 0);
  CHECK(relative_gap({1, 0x1p-80}, 1) == 0x1p-80);
  CHECK(std::isinf(relative_gap({1, 0}, INFINITY)));
}

TEST_CASE("the filter refuses what its bound cannot tell and never errs on the rest") {
  const Filtered tiny(0x1p-70), one(1);
  CHECK(sign(tiny) == 1);
  CHECK(sign(Filtered(0)) == 0);
  CHECK(sign(Filtered(Filtered(0) * Filtered(1e308))) == 0);
  // Exact in binary128, but the bound cannot know it.
  CHECK_THROWS_AS(sign((one + tiny) - one - tiny), Uncertain);
  CHECK_THROWS_AS(to_exact((one + Filtered(0x1p-100)) - one), Uncertain);
  CHECK_THROWS_AS(one / Filtered(0), Uncertain);
  const Filtered huge(1e308), h4 = huge * huge * huge * huge, h8 = h4 * h4, h16 = h8 * h8;
  CHECK(sign(h16 - h8) == 1);
  CHECK_THROWS_AS(sign(h16 * h4), Uncertain);
  const Filtered least(5e-324), l4 = least * least * least * least, l16 = l4 * l4 * l4 * l4;
  CHECK_THROWS_AS(sign(l16), Uncertain);

  Random random(21);
  int refused = 0;
  for (int i = 0; i < 20000; ++i) {
    // x y - z w with cancellation down to the last of 106 bits.
    const double x = random.uniform(1, 2), y = random.uniform(1, 2), z = random.uniform(1, 2);
    const double w = (x * y / z) * (1 + std::ldexp(random.uniform(-1, 1), -random.integer(40, 53)));
    const int exact = sign(mpq_class(mpq_class(x) * mpq_class(y) - mpq_class(z) * mpq_class(w)));
    try {
      REQUIRE(sign(Filtered(x) * Filtered(y) - Filtered(z) * Filtered(w)) == exact);
    } catch (const Uncertain&) {
      ++refused;
    }
  }
  CHECK(refused < 20);
}

TEST_CASE("both number types give the same roots, near and far from cancellation") {
  Random random(22);
  for (int i = 0; i < 5000; ++i) {
    const double a = std::fabs(random.log_uniform(-8, 8)), b = random.log_uniform(-8, 8);
    const double c = b * b / a * (1 - std::fabs(random.log_uniform(-15, 0)));
    const auto build = [&]<class N>() { return Quadratic<N>{N(a), N(b), N(c), N(N(b) * N(b) - N(a) * N(c))}; };
    const Quadratic<Filtered> filtered = build.operator()<Filtered>();
    const Quadratic<mpq_class> rational = build.operator()<mpq_class>();
    if (sign(rational.discriminant) <= 0) continue;
    for (const Root root : {Root::near, Root::far}) {
      const Exact exact = root_value(rational, root);
      CHECK(compare(rational, root, exact.value) == (exact.rest > 0) - (exact.rest < 0));
      CHECK(compare(rational, root, std::nextafter(exact.value, INFINITY)) == -1);
      CHECK(compare(rational, root, std::nextafter(exact.value, -INFINITY)) == 1);
      try {
        const Exact t = root_value(filtered, root);
        REQUIRE(t.value == exact.value);
        REQUIRE(std::fabs(t.rest - exact.rest) <= 0x1p-79 * std::fabs(exact.value));
      } catch (const Uncertain&) {
      }
    }
  }
}

TEST_CASE("a root is exact to 200 bits: t^2 = 2 has the digits of the square root of two") {
  const Quadratic<mpq_class> f{1, 0, -2, 2};
  const Exact root = root_value(f, Root::far);
  CHECK(root.value == 0x1.6a09e667f3bcdp+0);
  CHECK(root.rest == Approx(-0x1.bdd3413b26456p-54).epsilon(1e-15));
  CHECK(root_value(f, Root::near).value == -0x1.6a09e667f3bcdp+0);
}
