// SPDX-License-Identifier: MIT
// cl/math/exp_log_lanes.h and erfc_lanes.h against MPFR: the stated error bounds over the whole range, exact values,
// ends. 6 s. STRAHL_CASES: points for each function in float, a quarter of them in double.
#include <mpfr.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "cl/math_tiers.h"
#include "oracle/big_float.h"
#include "oracle/random.h"
#include "support/asked.h"

using namespace strahl::test;
using strahl::oracle::BigFloat;
using strahl::oracle::Exact;
using strahl::oracle::Random;

namespace {

double ulp_error(float computed, const Exact& exact) { return strahl::oracle::ulp_error_f32(computed, exact); }
double ulp_error(double computed, const Exact& exact) { return strahl::oracle::ulp_error_f64(computed, exact); }

Exact exact_exp_minus(double a) {
  BigFloat x;
  mpfr_set_d(x.get(), -a, MPFR_RNDN);
  mpfr_exp(x.get(), x.get(), MPFR_RNDN);
  return to_exact(x);
}

Exact exact_minus_log(double u) {
  BigFloat x;
  mpfr_set_d(x.get(), u, MPFR_RNDN);
  mpfr_log(x.get(), x.get(), MPFR_RNDN);
  mpfr_neg(x.get(), x.get(), MPFR_RNDN);
  return to_exact(x);
}

Exact exact_erfcx(double a) {
  BigFloat x, square;
  mpfr_set_d(x.get(), a, MPFR_RNDN);
  mpfr_sqr(square.get(), x.get(), MPFR_RNDN);
  mpfr_exp(square.get(), square.get(), MPFR_RNDN);
  mpfr_erfc(x.get(), x.get(), MPFR_RNDN);
  mpfr_mul(x.get(), x.get(), square.get(), MPFR_RNDN);
  return to_exact(x);
}

/// Evenly spread, by exponent, and as 1 minus something small.
template <class Real, class Function, class Oracle>
double worst_error(Function function, Oracle oracle, double most, double least_exponent, int count) {
  Random random(17);
  double worst = 0;
  for (int i = 0; i < count; ++i) {
    double x = most * (i + 0.5) / count;
    if (i % 3 == 1) x = std::min(std::fabs(random.log_uniform(least_exponent, std::log10(most))), most);
    if (i % 3 == 2 && most == 1) x = 1 - std::fabs(random.log_uniform(-7, -0.3));
    const Real rounded = static_cast<Real>(x);
    const double error = ulp_error(function(rounded), oracle(rounded));
    if (!(error <= worst)) worst = error;
  }
  return worst;
}

template <class Real>
int count() {
  return static_cast<int>(count_asked_for("STRAHL_CASES", 1 << 15)) / (sizeof(Real) == 4 ? 1 : 4);
}

}  // namespace

TEMPLATE_TEST_CASE("exp_minus keeps its bound", "", float, double) {
  const auto function = [](TestType a) { return exp_minus(a); };
  const double most = sizeof(TestType) == 4 ? 87 : 708;
  const double worst = worst_error<TestType>(function, exact_exp_minus, most, -12, count<TestType>());
  CHECK(worst <= 1);
  CHECK(worst > 0.5);
  CHECK(exp_minus(TestType(0)) == 1);
  for (const double beyond : {1.01 * most, 1e30}) CHECK(exp_minus(static_cast<TestType>(beyond)) == 0);
  CHECK(exp_minus(std::numeric_limits<TestType>::infinity()) == 0);
}

TEMPLATE_TEST_CASE("minus_log keeps its bound", "", float, double) {
  const auto function = [](TestType u) { return minus_log(u); };
  const double worst = worst_error<TestType>(function, exact_minus_log, 1, -37, count<TestType>());
  CHECK(worst <= 1);
  CHECK(worst > 0.5);
  CHECK(minus_log(TestType(1)) == 0);
  CHECK(std::isfinite(minus_log(std::numeric_limits<TestType>::min())));
}

TEMPLATE_TEST_CASE("the inverse of erf leads back to the share", "", float, double) {
  // erfc holds small shares to their last digits.
  Random random(19);
  for (const auto& [least_exponent, bound] : {std::pair(-7.0, 4e-7), std::pair(-9.0, 2e-4)})
    for (int i = 0; i < count<TestType>(); ++i) {
      const auto share = static_cast<TestType>(0.5 * std::fabs(random.log_uniform(least_exponent, 0)));
      const double x = erf_inverse(share);
      INFO("share " << share);
      // A share's relative error is that of x, times 2 x e^(-x^2) / (sqrt(pi) erfc(-x)), below 2 x^2 + 1.
      REQUIRE(std::erfc(-x) / 2 == Approx(double{share}).epsilon((2 * x * x + 1) * bound));
      if (share > TestType(1e-5))
        REQUIRE(erf_inverse(TestType(1) - share) == Approx(-x).epsilon(sizeof share == 4 ? 3e-3 : 1e-6));
    }
  CHECK(erf_inverse(TestType(0.5)) == 0);
}

TEMPLATE_TEST_CASE("erfcx keeps its bound", "", float, double) {
  const auto function = [](TestType a) { return erfcx(a); };
  const double worst = worst_error<TestType>(function, exact_erfcx, 12, -12, count<TestType>());
  CHECK(worst <= 6);
  CHECK(worst > 0.5);
  CHECK(erfcx(TestType(0)) == Approx(1).epsilon(6 * std::numeric_limits<TestType>::epsilon()));
  // 1 / (a sqrt(pi)).
  CHECK(erfcx(TestType(1e20)) * 1e20 ==
        Approx(0.5641895835477563).epsilon(6 * std::numeric_limits<TestType>::epsilon()));
}
