// SPDX-License-Identifier: MIT
// The arithmetic of a trade-off study on numbers and pictures whose answer is known.
#include <catch2/catch.hpp>
#include <cmath>

#include "errors.h"
#include "study/hashed.h"
#include "study/tradeoff/error_parts.h"
#include "study/tradeoff/pareto.h"
#include "study/tradeoff/power_law.h"
#include "study/tradeoff/work_estimate.h"

namespace strahl::test {
namespace {

Image flat(int side, float value) {
  Image image;
  image.width = image.height = side;
  image.data.assign(static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * 3, value);
  return image;
}

/// Normal deviates by their number (Box, Muller 1958).
double normal(std::uint64_t number) {
  const double radius = std::sqrt(-2 * std::log(1 - hashed_uniform(2 * number)));
  return radius * std::cos(2 * std::acos(-1.0) * hashed_uniform(2 * number + 1));
}

/// 0.5 everywhere plus `offset` plus noise.
Image noisy(int side, double offset, double deviation, std::uint64_t seed) {
  Image image = flat(side, 0.5F);
  for (std::size_t i = 0; i < image.data.size(); ++i)
    image.data[i] += static_cast<float>(offset + deviation * normal(seed * 1000000 + i));
  return image;
}

TEST_CASE("the front is what nothing beats") {
  using Front = std::vector<bool>;
  CHECK(pareto_front({}).empty());
  CHECK(pareto_front({{1, 1}}) == Front{true});
  CHECK(pareto_front({{1, 4}, {2, 2}, {3, 3}, {4, 1}, {4, 2}}) == Front{true, true, false, true, false});
  CHECK(pareto_front({{1, 1}, {1, 1}, {1, 2}, {2, 1}}) == Front{true, true, false, false});
}

TEST_CASE("a power law gives itself, whatever it is") {
  std::vector<std::pair<double, double>> points;
  for (const double x : {0.01, 0.04, 0.3, 2.0, 9.0}) points.emplace_back(x, 0.7 * std::pow(x, -0.5));
  const std::optional<PowerLaw> law = fit_power_law(points);
  REQUIRE(law);
  CHECK(law->slope == Approx(-0.5));
  CHECK(law->factor == Approx(0.7));
  CHECK(law->slope_high - law->slope_low < 1e-6);
  CHECK(law->points == 5);
}

TEST_CASE("what cannot be fitted is not") {
  CHECK_FALSE(fit_power_law({{1, 1}, {2, 2}}));
  CHECK_FALSE(fit_power_law({{1, 1}, {2, 2}, {3, 0}}));
  CHECK_FALSE(fit_power_law({{1, 1}, {1, 2}, {1, 3}}));
}

TEST_CASE("the slope of a textbook's example and its interval") {
  // y = e^(x), residuals +d, -2d, +d: slope 1, s^2 = 6 d^2 / 1, standard error sqrt(6 d^2 / 2), t(1) = 12.706.
  const double d = 0.1;
  const std::optional<PowerLaw> law =
      fit_power_law({{1, std::exp(d)}, {std::exp(1.0), std::exp(1 - 2 * d)}, {std::exp(2.0), std::exp(2 + d)}});
  REQUIRE(law);
  CHECK(law->slope == Approx(1));
  CHECK(law->slope_high - law->slope == Approx(12.7062 * std::sqrt(3) * d));
  CHECK(law->slope - law->slope_low == Approx(12.7062 * std::sqrt(3) * d));
}

TEST_CASE("the interval of a slope holds it in 95 of 100 cases") {
  for (const int n : {3, 5, 30}) {
    int inside = 0;
    const int cases = 2000;
    for (int i = 0; i < cases; ++i) {
      std::vector<std::pair<double, double>> points;
      for (int k = 0; k < n; ++k)
        points.emplace_back(std::exp(k), std::exp(-0.5 * k + 0.3 * normal(static_cast<std::uint64_t>(i * 100 + k))));
      const std::optional<PowerLaw> law = fit_power_law(points);
      inside += law && law->slope_low <= -0.5 && -0.5 <= law->slope_high ? 1 : 0;
    }
    INFO(n << " points: " << inside << " of " << cases);
    CHECK(inside > 0.935 * cases);
    CHECK(inside < 0.965 * cases);
  }
}

TEST_CASE("pictures of a known spread about a known offset, exactly") {
  // Mean 0.75, unbiased variance (0.25^2 + 0 + 0.25^2) / 2 = 1/16, about a reference of 0.25.
  const ErrorParts parts = error_parts({flat(4, 0.5F), flat(4, 0.75F), flat(4, 1.0F)}, flat(4, 0.25F), 0);
  CHECK(parts.variance == Approx(1.0 / 16));
  CHECK(parts.bias2 == Approx(0.25 - 1.0 / 48));
  CHECK(parts.mse == Approx((0.0625 + 0.25 + 0.5625) / 3));
  CHECK(parts.mse == Approx(parts.bias2 + parts.variance));
  CHECK(parts.bias2_error == Approx(0).margin(1e-8));  // The same in every pixel.
  CHECK(error_parts({flat(4, 0.5F), flat(4, 0.75F), flat(4, 1.0F)}, flat(4, 0.25F), 0.1).bias2 ==
        Approx(0.25 - 1.0 / 48 - 0.1));
}

TEST_CASE("bias and variance of noise, within their own errors") {
  const int side = 64;
  const double reference_deviation = 0.03;
  const Image reference = noisy(side, 0, reference_deviation, 99);
  for (const double bias : {0.0, 0.02, 0.3})
    for (const double deviation : {0.01, 0.2}) {
      INFO("bias " << bias << ", deviation " << deviation);
      std::vector<Image> pictures;
      for (std::uint64_t seed = 1; seed <= 3; ++seed) pictures.push_back(noisy(side, bias, deviation, seed));
      const ErrorParts parts = error_parts(pictures, reference, reference_deviation * reference_deviation);
      const double truth = bias * bias + deviation * deviation + reference_deviation * reference_deviation;
      CHECK(parts.variance == Approx(deviation * deviation).epsilon(0.03));
      CHECK(std::fabs(parts.bias2 - bias * bias) < 3 * parts.bias2_error);
      CHECK(parts.bias2_error < 0.02 * truth);
      CHECK(parts.mse == Approx(truth).epsilon(0.03));
    }
}

TEST_CASE("the interval of the RMSE holds it in 95 of 100 cases") {
  const Image reference = flat(8, 0.5F);
  int inside = 0;
  const int cases = 400;
  for (int i = 0; i < cases; ++i) {
    std::vector<Image> pictures;
    for (int k = 0; k < 3; ++k) pictures.push_back(noisy(8, 0.05, 0.1, static_cast<std::uint64_t>(100 + 3 * i + k)));
    const ErrorParts parts = error_parts(pictures, reference, 0);
    const double truth = std::sqrt(0.05 * 0.05 + 0.1 * 0.1);
    inside += parts.rmse_low() <= truth && truth <= parts.rmse_high() ? 1 : 0;
  }
  INFO(inside << " of " << cases);
  CHECK(inside > 0.92 * cases);
  CHECK(inside < 0.98 * cases);
}

TEST_CASE("what cannot be taken apart") {
  CHECK_THROWS_AS(error_parts({flat(4, 1)}, flat(4, 1), 0), std::logic_error);
  CHECK_THROWS_AS(error_parts({flat(4, 1), flat(5, 1)}, flat(4, 1), 0), InputError);
  Image broken = flat(4, 1);
  broken.at(1, 2, 0) = std::nanf("");
  CHECK_THROWS_AS(error_parts({flat(4, 1), flat(4, 1)}, broken, 0), InputError);
}

TEST_CASE("what is left is told from what like work took") {
  WorkEstimate work;
  work.expect("slow", 10);
  work.expect("fast", 10);
  work.expect("unknown", 10);
  CHECK_FALSE(work.seconds_left());
  work.done("slow", 5, 10);
  CHECK(*work.seconds_left() == Approx(5 * 2 + 10 * 2 + 10 * 2));
  work.done("fast", 5, 1);
  CHECK(*work.seconds_left() == Approx(5 * 2 + 5 * 0.2 + 10 * 1.1));
  work.done("slow", 5, 10);
  work.done("fast", 5, 1);
  work.done("unknown", 10, 3);
  CHECK(*work.seconds_left() == 0);
}

}  // namespace
}  // namespace strahl::test
