// SPDX-License-Identifier: MIT
// cl/math/angle.h and sincos_lanes.h against MPFR: the stated error bounds over the whole range, exact values,
// symmetries.
#include <mpfr.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "cl/angle_tiers.h"
#include "oracle/big_float.h"
#include "oracle/exact.h"
#include "oracle/random.h"

using strahl::oracle::BigFloat;
using strahl::oracle::Exact;
using strahl::oracle::Random;
using strahl::test::atan2_turns;
using strahl::test::sincos_turns;

namespace {

constexpr double sincos_bound = 0.80;
constexpr double atan2_bound = 1.75;

double ulp_error(float computed, const Exact& exact) { return strahl::oracle::ulp_error_f32(computed, exact); }
double ulp_error(double computed, const Exact& exact) { return strahl::oracle::ulp_error_f64(computed, exact); }

class Reference {
 public:
  Reference() {
    mpfr_const_pi(two_pi_.get(), MPFR_RNDN);
    mpfr_mul_2ui(two_pi_.get(), two_pi_.get(), 1, MPFR_RNDN);
  }

  void sincos(double turns, Exact* sine, Exact* cosine) {
    mpfr_set_d(x_.get(), turns, MPFR_RNDN);
    mpfr_frac(x_.get(), x_.get(), MPFR_RNDN);
    mpfr_mul(x_.get(), x_.get(), two_pi_.get(), MPFR_RNDN);
    mpfr_sin_cos(s_.get(), c_.get(), x_.get(), MPFR_RNDN);
    *sine = to_exact(s_);
    *cosine = to_exact(c_);
  }

  Exact atan2(double y, double x) {
    mpfr_set_d(s_.get(), y, MPFR_RNDN);
    mpfr_set_d(c_.get(), x, MPFR_RNDN);
    mpfr_atan2(x_.get(), s_.get(), c_.get(), MPFR_RNDN);
    mpfr_div(x_.get(), x_.get(), two_pi_.get(), MPFR_RNDN);
    if (mpfr_sgn(x_.get()) < 0) mpfr_add_ui(x_.get(), x_.get(), 1, MPFR_RNDN);
    return to_exact(x_);
  }

 private:
  BigFloat two_pi_, x_, s_, c_;
};

template <class Real>
struct Worst {
  double error = 0;
  Real at = 0, at_second = 0;

  void take(double e, Real x, Real y = 0) {
    if (!(e <= error)) error = e, at = x, at_second = y;
  }
};

template <class Real>
Worst<Real> sincos_error(int count, double least, double most) {
  Reference reference;
  Random random(11);
  Worst<Real> worst;
  Exact sine, cosine;
  for (int i = 0; i < count; ++i) {
    // Every other angle evenly spread over the range, every other one with an evenly spread exponent.
    const double even = least + (most - least) * (i + random.uniform()) / count;
    const Real x = static_cast<Real>(i % 2 ? even : random.log_uniform(-12, std::log10(most)));
    // Multiples of a quarter are exact and have their own test; MPFR's sine of its rounded pi is not quite 0.
    if (std::fmod(x, Real(0.25)) == 0) continue;
    Real s, c;
    sincos_turns(x, &s, &c);
    reference.sincos(x, &sine, &cosine);
    worst.take(std::max(ulp_error(s, sine), ulp_error(c, cosine)), x);
  }
  return worst;
}

template <class Real>
Worst<Real> atan2_error(int count, double decades) {
  Reference reference;
  Random random(12);
  Worst<Real> worst;
  bool is_in_range = true;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * (i + random.uniform()) / count;
    const double scale = random.log_uniform(-decades, decades);
    // Three laws: any angle, any ratio, next to the diagonals and the limits of the reduction.
    double x = scale * std::cos(angle), y = scale * std::sin(angle);
    if (i % 3 == 1) y *= random.log_uniform(-decades / 2, 0);
    if (i % 3 == 2) y = x * (i % 2 ? 1 : 0.41421356237309505) * (1 + random.log_uniform(-16, -1));
    if (i % 5 == 0) std::swap(x, y);
    const Real rx = static_cast<Real>(x), ry = static_cast<Real>(y);
    const Real turns = atan2_turns(ry, rx);
    is_in_range = is_in_range && turns >= 0 && turns < 1;
    worst.take(ulp_error(turns, reference.atan2(ry, rx)), ry, rx);
  }
  CHECK(is_in_range);
  return worst;
}

}  // namespace

TEMPLATE_TEST_CASE("sincos_turns keeps its bound in [0, 1)", "", float, double) {
  const int count = sizeof(TestType) == 4 ? 1 << 19 : 1 << 17;
  const Worst<TestType> worst = sincos_error<TestType>(count, 0, 1);
  CAPTURE(worst.at);
  CHECK(worst.error <= sincos_bound);
  CHECK(worst.error > 0.5);
}

TEST_CASE("sincos_turns in float keeps its bound against double on 2^22 floats of [2^-21, 1)") {
  Worst<float> worst;
  const std::uint32_t first = 0x35000000u, end = 0x3f800000u, step = 41;
  static_assert((end - first) / step > 1u << 22);
  for (std::uint32_t bits = first; bits < end; bits += step) {
    float x, s, c;
    std::memcpy(&x, &bits, sizeof x);
    double sine, cosine;
    sincos_turns(x, &s, &c);
    sincos_turns(double{x}, &sine, &cosine);
    worst.take(std::max(ulp_error(s, {sine, 0}), ulp_error(c, {cosine, 0})), x);
  }
  CAPTURE(worst.at);
  CHECK(worst.error <= sincos_bound);
}

TEMPLATE_TEST_CASE("sincos_turns keeps its bound for any finite angle", "", float, double) {
  const double most = std::ldexp(1.0, std::numeric_limits<TestType>::digits - 2);
  const Worst<TestType> worst = sincos_error<TestType>(1 << 15, -most, most);
  CAPTURE(worst.at);
  CHECK(worst.error <= sincos_bound);
}

TEMPLATE_TEST_CASE("sincos_turns is exact at quarters and odd and even about 0", "", float, double) {
  TestType s, c;
  const TestType sines[4] = {0, 1, 0, -1};
  for (int quarter = -4000; quarter <= 4000; ++quarter) {
    sincos_turns(static_cast<TestType>(quarter) / 4, &s, &c);
    REQUIRE(s == sines[quarter & 3]);
    REQUIRE(c == sines[(quarter + 1) & 3]);
  }
  Random random(13);
  for (int i = 0; i < 10000; ++i) {
    const TestType x = static_cast<TestType>(random.log_uniform(-10, 10));
    TestType mirrored_s, mirrored_c;
    sincos_turns(x, &s, &c);
    sincos_turns(-x, &mirrored_s, &mirrored_c);
    REQUIRE(mirrored_s == -s);
    REQUIRE(mirrored_c == c);
  }
  for (const TestType x : {std::numeric_limits<TestType>::max(), std::numeric_limits<TestType>::lowest()}) {
    sincos_turns(x, &s, &c);
    CHECK(s == 0);
    CHECK(c == 1);
  }
}

TEMPLATE_TEST_CASE("atan2_turns keeps its bound in [0, 1)", "", float, double) {
  const bool is_float = sizeof(TestType) == 4;
  const Worst<TestType> worst = atan2_error<TestType>(is_float ? 1 << 18 : 1 << 16, is_float ? 36 : 300);
  CAPTURE(worst.at, worst.at_second);
  CHECK(worst.error <= atan2_bound);
  CHECK(worst.error > 0.5);
}

TEMPLATE_TEST_CASE("atan2_turns at axes, diagonals and limits", "", float, double) {
  using Limits = std::numeric_limits<TestType>;
  const TestType zero = 0, one = 1, most = Limits::max(), least = Limits::denorm_min();
  CHECK(atan2_turns(zero, zero) == 0);
  CHECK(atan2_turns(-zero, -zero) == 0);
  for (const TestType r : {least, Limits::min(), one, most}) {
    CHECK(atan2_turns(zero, r) == 0);
    CHECK(atan2_turns(-zero, r) == 0);
    CHECK(atan2_turns(r, r) == TestType(0.125));
    CHECK(atan2_turns(r, zero) == TestType(0.25));
    CHECK(atan2_turns(r, -r) == TestType(0.375));
    CHECK(atan2_turns(zero, -r) == TestType(0.5));
    CHECK(atan2_turns(-zero, -r) == TestType(0.5));
    CHECK(atan2_turns(-r, -r) == TestType(0.625));
    CHECK(atan2_turns(-r, zero) == TestType(0.75));
    CHECK(atan2_turns(-r, r) == TestType(0.875));
  }
  CHECK(atan2_turns(least, most) == 0);
  CHECK(atan2_turns(-least, most) == 1 - Limits::epsilon() / 2);
  CHECK(atan2_turns(-Limits::epsilon() / 8, one) == 1 - Limits::epsilon() / 2);
}
