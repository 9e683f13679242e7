// SPDX-License-Identifier: MIT
// cl/math on the host: vectors against MPFR, random numbers against what uniform ones look like.
#include <mpfr.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

#include "../../cl/samplers/uses.h"
#include "cl/math_tiers.h"
#include "oracle/big_float.h"
#include "oracle/random.h"

using namespace strahl::test;
using strahl::oracle::BigFloat;
using strahl::oracle::Exact;
using strahl::oracle::Random;

namespace {

double ulp_error(float computed, const Exact& exact) { return strahl::oracle::ulp_error_f32(computed, exact); }
double ulp_error(double computed, const Exact& exact) { return strahl::oracle::ulp_error_f64(computed, exact); }

template <class Real>
class Vectors {
 public:
  using Array = std::array<Real, 3>;

  /// Each component anywhere in the range, or all three at one scale.
  Array draw() {
    constexpr double decades = sizeof(Real) == 4 ? 36 : 300;
    Array v{};
    const double scale = random_.log_uniform(-decades, decades);
    const bool at_one_scale = random_.sign() > 0;
    for (Real& x : v)
      x = static_cast<Real>(at_one_scale ? scale * random_.uniform(-1, 1) : random_.log_uniform(-decades, decades));
    return v;
  }
  Exact length(const Array& v) {
    norm(v);
    return to_exact(norm_);
  }
  Exact unit(const Array& v, std::size_t i) {
    norm(v);
    mpfr_set_d(x_.get(), static_cast<double>(v[i]), MPFR_RNDN);
    mpfr_div(x_.get(), x_.get(), norm_.get(), MPFR_RNDN);
    return to_exact(x_);
  }

 private:
  void norm(const Array& v) {
    mpfr_set_zero(norm_.get(), 1);
    for (const Real x : v) {
      mpfr_set_d(x_.get(), static_cast<double>(x), MPFR_RNDN);
      mpfr_sqr(x_.get(), x_.get(), MPFR_RNDN);
      mpfr_add(norm_.get(), norm_.get(), x_.get(), MPFR_RNDN);
    }
    mpfr_sqrt(norm_.get(), norm_.get(), MPFR_RNDN);
  }

  Random random_{21};
  BigFloat norm_, x_;
};

}  // namespace

TEMPLATE_TEST_CASE("normalize3 is good to 2.5 ulp and length3 to 2, at every scale", "", float, double) {
  Vectors<TestType> vectors;
  double worst_unit = 0, worst_length = 0;
  for (int i = 0; i < 50000; ++i) {
    const auto v = vectors.draw(), n = normalize3(v);
    worst_length = std::max(worst_length, ulp_error(length3(v), vectors.length(v)));
    for (std::size_t k = 0; k < 3; ++k) {
      const Exact exact = vectors.unit(v, k);
      // A component that is subnormal beside the others has lost digits when it was scaled.
      if (std::fabs(exact.value) < 4 * static_cast<double>(std::numeric_limits<TestType>::min())) continue;
      worst_unit = std::max(worst_unit, ulp_error(n[k], exact));
    }
  }
  CHECK(worst_unit <= 2.5);
  CHECK(worst_length <= 2);
  CHECK(worst_unit > 0.5);
}

TEMPLATE_TEST_CASE("normalize3 and length3 of extremes: no overflow, no underflow, zero stays zero", "", float,
                   double) {
  using Limits = std::numeric_limits<TestType>;
  using Array = std::array<TestType, 3>;
  for (const TestType x :
       {Limits::denorm_min(), Limits::min(), TestType(1), std::ldexp(TestType(1), Limits::max_exponent - 1)}) {
    CHECK(normalize3(Array{x, 0, 0}) == Array{1, 0, 0});
    CHECK(normalize3(Array{0, -x, 0}) == Array{0, -1, 0});
    CHECK(length3(Array{0, 0, -x}) == x);
    const Array diagonal = normalize3(Array{x, x, x});
    CHECK(diagonal[0] == Approx(std::sqrt(1.0 / 3)).epsilon(1e-6));
    CHECK(diagonal == normalize3(Array{1, 1, 1}));
  }
  CHECK(normalize3(Array{0, 0, 0}) == Array{0, 0, 0});
  CHECK(length3(Array{0, 0, 0}) == 0);
}

TEMPLATE_TEST_CASE("difference_of_products is good to 1.5 ulp, its sign always right", "", float, double) {
  Random random(22);
  BigFloat exact, product;
  double worst = 0;
  for (int i = 0; i < 200000; ++i) {
    TestType x[4];
    for (TestType& f : x) f = static_cast<TestType>(random.log_uniform(-3, 3));
    // Half of them cancel down to the last places.
    if (i % 2)
      x[3] = x[0] * x[1] / x[2] *
             (1 + static_cast<TestType>(random.integer(-2, 2)) * std::numeric_limits<TestType>::epsilon());
    mpfr_set_d(exact.get(), static_cast<double>(x[0]), MPFR_RNDN);
    mpfr_mul_d(exact.get(), exact.get(), static_cast<double>(x[1]), MPFR_RNDN);
    mpfr_set_d(product.get(), static_cast<double>(x[2]), MPFR_RNDN);
    mpfr_mul_d(product.get(), product.get(), static_cast<double>(x[3]), MPFR_RNDN);
    mpfr_sub(exact.get(), exact.get(), product.get(), MPFR_RNDN);
    const TestType computed = difference_of_products(x[0], x[1], x[2], x[3]);
    const int sign = computed > 0 ? 1 : computed < 0 ? -1 : 0;
    REQUIRE(sign == (mpfr_sgn(exact.get()) > 0) - (mpfr_sgn(exact.get()) < 0));
    if (sign != 0) worst = std::max(worst, ulp_error(computed, to_exact(exact)));
  }
  CHECK(worst <= 1.5);
  CHECK(worst > 0.5);
}

TEST_CASE("random4 has the published method's bits and differs in every argument") {
  // pcg4d of (0, 0, 0, 0), worked out from the paper's listing in another language.
  const std::array<std::uint32_t, 4> origin = random4(0, 0, 0, 0);
  std::uint64_t v[4] = {1013904223, 1013904223, 1013904223, 1013904223};
  const auto mix = [&] {
    const int order[4][3] = {{0, 1, 3}, {1, 2, 0}, {2, 0, 1}, {3, 1, 2}};
    for (const auto& [to, a, b] : order) v[to] = (v[to] + v[a] * v[b]) % (std::uint64_t{1} << 32);
  };
  mix();
  for (std::uint64_t& x : v) x ^= x / 65536;
  mix();
  for (std::size_t i = 0; i < 4; ++i) CHECK(origin[i] == v[i]);
  std::set<std::array<std::uint32_t, 4>> seen = {origin};
  for (std::uint32_t i = 1; i < 10000; ++i)
    for (const auto& r : {random4(i, 0, 0, 0), random4(0, i, 0, 0), random4(0, 0, i, 0), random4(0, 0, 0, i)})
      REQUIRE(seen.insert(r).second);
}

TEST_CASE(
    "the streams of paths and shadow rays and the sensor's numbers depend neither on the sets of vertices nor on each "
    "other") {
  // Pairs of numbers in 8 x 8 cells, 2^16 of them: chi^2 with 63 degrees of freedom, of 4 x 4 x 4 x 8 pairs.
  constexpr std::size_t cells = 8;
  const std::array<std::uint32_t, 5> begins{0, STREAM_BEGIN, STREAM_BEGIN + STREAM_SHADOWS,
                                            STREAM_BEGIN + STREAM_BLENDS, FIRST_OF_SENSOR};
  for (const auto& [one, other] : {std::pair{0U, 1U}, std::pair{0U, 2U}, std::pair{1U, 2U}, std::pair{0U, 3U}})
    for (std::uint32_t k = 0; k < 8; ++k) {
      std::array<std::array<std::array<int, cells * cells>, 4>, 4> count{};
      for (std::uint32_t i = 0; i < 1 << 16; ++i) {
        const auto a = random4(i >> 6, i & 63, begins[one] + k, 0);
        const auto b = random4(i >> 6, i & 63, begins[other] + k, 0);
        for (std::size_t m = 0; m < 4; ++m)
          for (std::size_t n = 0; n < 4; ++n) ++count[m][n][(a[m] >> 29) * cells + (b[n] >> 29)];
      }
      for (const auto& of_first : count)
        for (const auto& of_both : of_first) {
          double chi2 = 0;
          for (const int n : of_both) chi2 += (n - 1024.0) * (n - 1024.0) / 1024.0;
          INFO(one << " " << other << " " << k);
          CHECK(chi2 < 135);
        }
    }
}

TEST_CASE("random_unit is uniform along pixels, samples, dimensions and seeds") {
  // 64 cells, 2^16 numbers: chi^2 with 63 degrees of freedom is below 121.1 in all but 1 of 10^5 draws; 16 are made.
  constexpr int cells = 64, numbers = 1 << 16;
  for (int argument = 0; argument < 4; ++argument) {
    std::array<std::array<int, cells>, 4> count{};
    for (std::uint32_t i = 0; i < numbers; ++i) {
      std::array<std::uint32_t, 4> at{17, 3, 5, 1};
      at[static_cast<std::size_t>(argument)] = i;
      const auto r = random4(at[0], at[1], at[2], at[3]);
      for (std::size_t k = 0; k < 4; ++k) ++count[k][static_cast<std::size_t>(random_unit(0.0, r[k]) * cells)];
    }
    for (const auto& cells_of_output : count) {
      const double expected = double{numbers} / cells;
      double chi2 = 0;
      for (const int n : cells_of_output) chi2 += (n - expected) * (n - expected) / expected;
      INFO("argument " << argument);
      CHECK(chi2 < 121.1);
      CHECK(chi2 > 20);
    }
  }
}

TEST_CASE("random_unit is within [0, 1)") {
  CHECK(random_unit(0.0f, 0u) == 0);
  CHECK(random_unit(0.0, 0u) == 0);
  CHECK(random_unit(0.0f, ~0u) == 1 - 0x1p-24f);
  CHECK(random_unit(0.0, ~0u) == 1 - 0x1p-32);
}
