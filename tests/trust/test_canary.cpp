// SPDX-License-Identifier: MIT
// The canary: its cases are as hard as they should be, sound devices hold, and arithmetic that is not IEEE 754's is
// named and costs the tiers that build on it.
#include <catch2/catch.hpp>
#include <cmath>

#include "support/devices.h"
#include "trust/canary.h"
#include "trust/canary_cases.h"
#include "trust/tier_choice.h"

using namespace strahl;
using namespace strahl::test;

namespace {

const CanaryGroup<float>& group(const std::vector<CanaryGroup<float>>& groups, CanaryProperty property) {
  for (const auto& found : groups)
    if (found.property == property) return found;
  throw std::logic_error("no such group");
}

/// Distance of x from the middle of two neighbouring floats, in units of their distance.
double from_middle(double x) {
  int exponent;
  const double scaled = std::ldexp(std::frexp(x, &exponent), 24);
  return std::fabs(scaled - std::floor(scaled) - 0.5);
}

const CanaryFinding& finding(const CanaryReport& report, const std::string& property) {
  for (const CanaryFinding& found : report.findings)
    if (found.property == property) return found;
  throw std::logic_error("no finding about " + property);
}

CanaryOptions replacing(const std::string& from, const std::string& to) {
  CanaryOptions options;
  options.lanes = 1;
  options.change = [from, to](ProgramSource& source) {
    const std::size_t at = source.text.find(from);
    REQUIRE(at != std::string::npos);
    source.text.replace(at, from.size(), to);
  };
  return options;
}

}  // namespace

TEST_CASE("quotients and roots are asked for next to the middle of two numbers") {
  const auto groups = canary_groups<float>();
  int close = 0;
  for (const auto& [a, b, c, d] : group(groups, CanaryProperty::division).cases)
    close += from_middle(static_cast<double>(a) / static_cast<double>(b)) < 0x1p-22;
  CHECK(close > 4000);
  close = 0;
  for (const auto& [a, b, c, d] : group(groups, CanaryProperty::square_root).cases)
    close += from_middle(std::sqrt(static_cast<double>(a))) < 0x1p-10;
  CHECK(close > 2000);
}

TEST_CASE("sums and products are asked for that are not exact, and cancel") {
  const auto groups = canary_groups<float>();
  int inexact = 0, cancelled = 0;
  for (const auto& input : group(groups, CanaryProperty::sums).cases) {
    const double a = static_cast<double>(input[0]), b = static_cast<double>(input[1]);
    const double sum = static_cast<double>(canary_expected(layout::CANARY_SUM, input));
    const double error = static_cast<double>(canary_expected(layout::CANARY_SUM_ERROR, input));
    // 2^-22 ... 2^22 by 24 bits: a double holds the sum.
    if (std::fabs(a) < 0x1p20 && std::fabs(a) > 0x1p-5 && std::fabs(b) > 0x1p-28) CHECK(sum + error == a + b);
    inexact += error != 0;
    cancelled += std::fabs(sum) < 0x1p-20 * std::fabs(a);
  }
  CHECK(inexact > 1500);
  CHECK(cancelled > 900);
}

TEST_CASE("PoCL holds in every tier and at every width") {
  require_pocl_and_rusticl();
  const Device device = Device::open("pocl");
  for (const Precision precision : {Precision::fast, Precision::stable, Precision::robust, Precision::fp64}) {
    INFO(precision_name(precision));
    const CanaryReport report = run_canary(device, precision);
    CHECK(report.tier.verdict == Verdict::holds);
    CHECK(report.tier.why.empty());
    CHECK(report.findings.size() == 15);
    for (const CanaryFinding& found : report.findings) CHECK(found.cases > 0);
  }
  CHECK(run_canary(device, Precision::robust, {8, {}}).tier.verdict == Verdict::holds);
}

TEST_CASE("Mesa's fma has no denormal results, which is named with the scale from which on it does not matter") {
  require_pocl_and_rusticl();
  const Device device = Device::open("llvmpipe");
  const CanaryReport its_own =
      run_canary(device, Precision::robust, replacing("{ return soft_fma(a, b, c); }", "{ return fma(a, b, c); }"));
  CHECK(its_own.tier.verdict == Verdict::degraded);
  CHECK(its_own.tier.why.find("holds for products above 2^-77, lengths above 2^-38") != std::string::npos);
  CHECK(finding(its_own, "fma with denormals").wrong > 0);
}

TEST_CASE("rusticl holds with an fma in integers, but for long loops and double precision") {
  require_pocl_and_rusticl();
  const Device device = Device::open("llvmpipe");
  CHECK_FALSE(device.info().fma);
  const CanaryReport robust = run_canary(device, Precision::robust);
  CHECK(robust.tier.verdict == Verdict::degraded);
  for (const CanaryFinding& found : robust.findings)
    if (found.property != "long loops") CHECK(found.verdict == Verdict::holds);
  // Recorded only: the dialect has no literal zeros in sums and products.
  CHECK(finding(robust, "literal zeros").wrong > 0);
  const CanaryReport fp64 = run_canary(device, Precision::fp64);
  CHECK(fp64.tier.verdict == Verdict::refused);
  CHECK(fp64.tier.why == "the device has no double precision");
}

TEST_CASE("wrong arithmetic is found out and named") {
  require_pocl_and_rusticl();
  const Device device = Device::open("pocl");
  struct Wrong {
    const char *property, *from, *to;
    Verdict robust;
  };
  for (const Wrong& wrong : {
           Wrong{"contraction off", "#pragma OPENCL FP_CONTRACT OFF", "#pragma OPENCL FP_CONTRACT ON",
                 Verdict::refused},
           Wrong{"sums", "realw of_b = s.hi - a;", "realw of_b = b;", Verdict::refused},
           Wrong{"products", "return fma(a, b, c);", "return a * b + c;", Verdict::refused},
           Wrong{"division", "CANARY_QUOTIENT * count, a / b", "CANARY_QUOTIENT * count, a * (R(1.0) / b)",
                 Verdict::refused},
           Wrong{"square root", "FN realw sqrt_w(realw a) { return real_sqrt(a); }",
                 "FN realw sqrt_w(realw a) { return native_sqrt(a) * R(1.0000001); }", Verdict::refused},
           Wrong{"NaN comparisons", "return -(int)(a <= b);", "return -(int)!(a > b);", Verdict::refused},
           Wrong{"order", "return -(int)(a < b);", "return -(int)(a - b < R(-0.0000001));", Verdict::refused},
           Wrong{"conversions", "(real)(int)x", "rint(x)", Verdict::refused},
           Wrong{"infinities", "CANARY_QUOTIENT * count, a / b",
                 "CANARY_QUOTIENT * count, min_w(max_w(a / b, -REAL_MAX), REAL_MAX)", Verdict::refused},
           Wrong{"denormals", "CANARY_PRODUCT * count, a * b",
                 "CANARY_PRODUCT * count, real_abs(a * b) < R(1.17549435e-38) ? R(0.0) : a * b", Verdict::refused},
           Wrong{"fma with denormals", "return fma(a, b, c);",
                 "real r = fma(a, b, c); return real_abs(r) < R(1.17549435e-38) ? R(0.0) : r;", Verdict::degraded},
           Wrong{"finite arithmetic", "CANARY_SUM * count, a + b", "CANARY_SUM * count, a + b * R(0.999)",
                 Verdict::refused},
       }) {
    INFO(wrong.property);
    const CanaryReport report = run_canary(device, Precision::robust, replacing(wrong.from, wrong.to));
    CHECK(finding(report, wrong.property).wrong > 0);
    CHECK_FALSE(finding(report, wrong.property).detail.empty());
    CHECK(report.tier.verdict == wrong.robust);
  }
}

TEST_CASE("a tier is chosen by name, or the default where it is not refused") {
  require_pocl_and_rusticl();
  const Device pocl = Device::open("pocl");
  CHECK(choose_tier(pocl, std::nullopt).tier.precision == Precision::robust);
  CHECK(choose_tier(pocl, std::nullopt).instead.empty());
  CHECK(choose_tier(pocl, Precision::fp64).tier.verdict == Verdict::holds);
  const Device rusticl = Device::open("llvmpipe");
  // Twice: measured, then remembered.
  for (int i = 0; i < 2; ++i) CHECK(choose_tier(rusticl, std::nullopt).tier.verdict == Verdict::degraded);
  CHECK_THROWS_AS(choose_tier(rusticl, Precision::fp64), NoDeviceError);
}

TEST_CASE("a device that ends long loops is known by it") {
  require_pocl_and_rusticl();
  CanaryOptions one_lane;
  one_lane.lanes = 1;
  const CanaryReport rusticl = run_canary(Device::open("llvmpipe"), Precision::stable, one_lane);
  REQUIRE(rusticl.tier.loop_turns);
  CHECK(*rusticl.tier.loop_turns > 65000);
  CHECK(*rusticl.tier.loop_turns < 65536);
  CHECK(rusticl.tier.verdict == Verdict::degraded);
  CHECK(rusticl.tier.why.find("ends loops after") != std::string::npos);
  CHECK_FALSE(run_canary(Device::open("pocl"), Precision::stable, one_lane).tier.loop_turns);
}

TEST_CASE("a device that ends loops so that no work-item can tell is refused") {
  require_pocl_and_rusticl();
  CanaryOptions options;
  options.lanes = 1;
  for (const std::string told : {"made == 3u", "made != 2u"}) {
    options.change = [&](ProgramSource& source) {
      const std::string right = "made == 2u";
      source.text.replace(source.text.find(right), right.size(), told);
    };
    CHECK(run_canary(Device::open("pocl"), Precision::stable, options).tier.verdict == Verdict::refused);
  }
}
