// SPDX-License-Identifier: MIT
// What a pilot's looks say of the whole render: the law, what passes cost, and intervals that hold as often as they
// say.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "render/pass_plan.h"
#include "render/prediction.h"

namespace strahl {
namespace {

double law_mse(double spp, double exponent) { return 0.04 * std::pow(spp, -exponent); }

std::vector<Look> exact_looks(double exponent) {
  std::vector<Look> looks;
  for (const double spp : {8.0, 32.0, 128.0}) looks.push_back({spp, law_mse(spp, exponent), 0.1, 1.1, 0.1});
  return looks;
}

/// What a renderer does with that goal, whose pictures tell `told` times the law's squared error.
int samples_of_render(double max_error, double exponent, double told, double upper) {
  RenderGoal goal;
  goal.max_error = max_error;
  PassPlan plan(goal, 1 << 21);
  int spp = 0;
  while (const std::optional<Pass> pass = plan.next(0, std::numeric_limits<double>::infinity())) {
    spp += pass->count;
    const double rmse = std::sqrt(told * law_mse(spp, exponent));
    if (plan.wants_error()) plan.estimated(ErrorEstimate{rmse, rmse, upper * rmse, 0});
  }
  return spp;
}

TEST_CASE("the law is the one that the looks follow") {
  for (const double exponent : {1.0, 1.4, 2.1}) {
    const ErrorTrend law = error_trend(exact_looks(exponent));
    CHECK(law.exponent == Approx(exponent));
    CHECK(law.spp == 128);
    CHECK(law.mse == Approx(law_mse(128, exponent)));
    CHECK(law.exponent_spread > 0);
  }
  CHECK(error_trend({{8, 0.1, 0.1, 1, 0}}).exponent_spread > 0.1);   // No slope was seen.
  CHECK(error_trend({{8, 0, 0, 1, 0}, {32, 0, 0, 1, 0}}).mse == 0);  // No noise at all.
}

TEST_CASE("passes cost what was seen, also where few samples cost as much as many") {
  const std::vector<PassCost> passes{{8, 1.0}, {32, 1.6}};
  CHECK(pass_seconds(passes, 8) == 1.0);
  CHECK(pass_seconds(passes, 20) == Approx(1.3));
  CHECK(pass_seconds(passes, 64) == Approx(3.2));
  CHECK(pass_seconds(passes, 4) == Approx(0.5));
}

TEST_CASE("the pilot's time varies as the render's does") {
  std::mt19937 random(5);
  std::normal_distribution<double> normal(0, repeat_spread);
  int held = 0;
  for (int i = 0; i < 1000; ++i) {
    RunCosts costs;
    costs.passes = {{32, std::exp(normal(random))}};
    costs.spread = ratio_spread;
    const Range seconds = predict({}, costs, {32, {}, {}}).seconds;
    const double render = std::exp(normal(random));
    held += seconds.low <= render && render <= seconds.high ? 1 : 0;
  }
  CHECK(held > 1000 * (prediction_confidence - 0.03));
}

/// The renderer ends where the interval's upper end is near the goal too, and looks only now and then.
TEST_CASE("the samples are those after which the renderer would end") {
  ErrorTrend law = error_trend(exact_looks(1.2));
  law.mse_spread = law.exponent_spread = law.told_spread = 0;
  law.upper = 1.25;
  const RunCosts costs{1, 0, {{8, 0.8}}, 0, 0, 0.5, 0};
  for (const double goal : {0.05, 0.02, 0.01, 0.004}) {
    const Prediction p = predict(law, costs, {1 << 21, goal, std::nullopt});
    const int spp = samples_of_render(goal, 1.2, 1, 1.25);
    CHECK(p.spp.low == spp);
    CHECK(p.spp.high == spp);
    CHECK(p.seconds.middle == Approx(1.5 + 0.1 * spp));
    CHECK(p.rmse->middle <= goal);
  }
}

TEST_CASE("a number of samples, and a time") {
  const RunCosts costs{1, 0, {{8, 0.8}}, 0.05, 0, 0.5, 0};
  const std::optional<ErrorTrend> law = error_trend(exact_looks(1.2));
  const Prediction samples = predict(law, costs, {100, std::nullopt, std::nullopt});
  CHECK(samples.spp.low == 100);
  CHECK(samples.spp.high == 100);
  CHECK(samples.seconds.middle == Approx(11.5).epsilon(0.01));
  CHECK(samples.seconds.low > 10);
  CHECK(samples.seconds.low < 11);

  const Prediction time = predict(law, costs, {1 << 21, std::nullopt, 5.0});
  CHECK(time.seconds.low == Approx(5));
  CHECK(time.seconds.high == Approx(5));
  CHECK(time.spp.middle == Approx(35).epsilon(0.01));
  CHECK(time.spp.low < 34);

  CHECK(predict(law, costs, {1 << 21, std::nullopt, 1.2}).spp.high == 0);  // The start alone takes longer.
  CHECK_FALSE(predict(std::nullopt, costs, {2, std::nullopt, std::nullopt}).rmse);
  CHECK(predict(law, costs, {1 << 21, 1e-9, 60.0}).seconds.middle == Approx(60));  // What holds first.
}

TEST_CASE("an error that nearly all of the samples say nothing of is predicted, if badly") {
  for (const double spread : {1.0, 30.0, 1e4, 1e8}) {
    INFO(spread);
    const std::vector<Look> looks{{8, 1e-10, spread, relative_upper(spread), spread}};
    for (const std::optional<double> max_error : {std::optional<double>(), std::optional<double>(1e-3)}) {
      const Prediction p =
          predict(error_trend(looks, spread), {0, 0, {{8, 1.0}}, 0, 0, 0, 0}, {1 << 21, max_error, std::nullopt});
      REQUIRE(p.rmse);
      CHECK(std::isfinite(p.rmse->high));
      CHECK(p.rmse->low <= p.rmse->middle);
      CHECK(p.rmse->middle <= p.rmse->high);
      CHECK(p.spp.high <= 1 << 21);
      CHECK(p.spp.low >= 8);
    }
  }
}

TEST_CASE("the intervals hold in nine of ten runs") {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(1.0, 1.6);
  const int trials = 200;
  const double spread = 0.15;
  int held = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const double exponent = uniform(random);
    std::vector<Look> looks;
    for (const double spp : {8.0, 32.0})
      looks.push_back({spp, law_mse(spp, exponent) * std::exp(spread * normal(random)), spread, 1.1, spread});
    const Prediction p = predict(error_trend(looks), {0, 0, {{8, 1.0}}, 0, 0, 0, 0}, {1 << 21, 0.01, std::nullopt});
    const int spp = samples_of_render(0.01, exponent, std::exp(spread * normal(random)), 1.1);
    if (p.spp.low <= spp && spp <= p.spp.high) ++held;
  }
  CHECK(held >= 170);
  CHECK(held <= 199);
}

}  // namespace
}  // namespace strahl
