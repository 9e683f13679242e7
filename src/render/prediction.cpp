// SPDX-License-Identifier: MIT
#include "render/prediction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "render/pass_plan.h"

namespace strahl {
namespace {

constexpr int imagined_runs = 1000;

/// The exponent is not constant: measured over a factor of 16 in the samples, it differs by about this much from that
/// over the next factor.
constexpr double bend = 0.1;

/// With one look there is no slope to see: squared errors fall as n^-1 (independent samples) to n^-1.5 (scrambled
/// Sobol points on edges).
constexpr double unseen_exponent = 1.25, unseen_exponent_spread = 0.2;

/// Errors that hardly fall with more samples are caused by fireflies that the pilot has met by chance. With an exponent
/// below this, no number of samples reaches a goal in practice.
constexpr double least_exponent = 0.25;

/// Two looks never agree better than this: Sobol points whose number is no power of two are less even.
constexpr double least_spread = 0.05;

/// The fewest samples that allow an estimate of the error.
constexpr double told_from = 4;

/// The standard deviation of the logarithm of what is log-normal and has that relative one. They agree where both are
/// small; an error that few samples tell may be off by a thousand times what they say.
double of_logarithm(double spread) { return std::sqrt(std::log1p(spread * spread)); }

struct ImaginedRun {
  double seconds = 0, spp = 0, rmse = 0;
};

class Imagination {
 public:
  Imagination(const std::optional<ErrorTrend>& law, const RunCosts& costs, const PredictedGoal& goal)
      : law_(law), costs_(costs), goal_(goal) {}

  ImaginedRun run() {
    const double slowness = std::exp(costs_.spread * normal_(random_));
    double seconds = costs_.start + costs_.start_more * uniform_(random_);
    const ErrorTrend law = drawn_law();
    const double told = std::exp(law.told_spread * normal_(random_));
    const auto rmse_at = [&](double spp) { return std::sqrt(law.mse * told * std::pow(spp / law.spp, -law.exponent)); };
    RenderGoal goal;
    if (law_) goal.max_error = goal_.max_error;
    PassPlan plan(goal, goal_.spp);
    double spp = 0;
    while (const std::optional<Pass> pass = plan.next(0, std::numeric_limits<double>::infinity())) {
      const double cost = slowness * pass_seconds(costs_.passes, pass->count);
      const double left = goal_.seconds ? *goal_.seconds - costs_.end - seconds : cost;
      if (left < cost) {
        spp += pass->count * std::max(0.0, left / cost);
        seconds += std::max(0.0, left);
        break;
      }
      seconds += cost;
      spp += pass->count;
      if (!plan.wants_error()) continue;
      seconds += costs_.look;
      const double rmse = rmse_at(spp);
      plan.estimated(ErrorEstimate{rmse, rmse, rmse * law.upper, 0});
    }
    seconds += costs_.end;
    if (!goal_.seconds) seconds *= 1 + costs_.extra_share * uniform_(random_);
    return {seconds, spp, rmse_at(std::max(spp, 1.0))};
  }

 private:
  ErrorTrend drawn_law() {
    ErrorTrend law = law_.value_or(ErrorTrend{});
    law.mse *= std::exp(law.mse_spread * normal_(random_));
    law.exponent = std::max(least_exponent, law.exponent + law.exponent_spread * normal_(random_));
    return law;
  }

  const std::optional<ErrorTrend>& law_;
  const RunCosts& costs_;
  const PredictedGoal& goal_;
  std::mt19937_64 random_{1};
  std::normal_distribution<double> normal_;
  std::uniform_real_distribution<double> uniform_;
};

Range range_of(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
  };
  const double tail = (1 - prediction_confidence) / 2;
  return {at(tail), at(0.5), at(1 - tail)};
}

}  // namespace

ErrorTrend error_trend(const std::vector<Look>& looks, double common_spread) {
  const Look& last = looks.back();
  const double common = of_logarithm(common_spread);
  ErrorTrend law{last.spp,
                 last.mse,
                 unseen_exponent,
                 std::hypot(of_logarithm(last.spread), common),
                 unseen_exponent_spread,
                 of_logarithm(last.told),
                 last.upper};
  // Weighted least squares of log mse on log (spp / last.spp).
  double w = 0, x = 0, y = 0, xx = 0, xy = 0;
  int seen = 0;
  for (const Look& look : looks) {
    if (!(look.mse > 0)) continue;
    const double spread = of_logarithm(look.spread);
    const double weight = 1 / (spread * spread + least_spread * least_spread);
    const double log_n = std::log(look.spp / last.spp), log_mse = std::log(look.mse);
    w += weight;
    x += weight * log_n;
    y += weight * log_mse;
    xx += weight * log_n * log_n;
    xy += weight * log_n * log_mse;
    ++seen;
  }
  if (seen < 2 || !(last.mse > 0)) return law;
  const double determinant = w * xx - x * x;
  law.exponent = -(w * xy - x * y) / determinant;
  law.mse = std::exp((xx * y - x * xy) / determinant);
  law.exponent_spread = std::hypot(std::sqrt(w / determinant), bend);
  law.mse_spread = std::hypot(std::sqrt(xx / determinant), common);
  return law;
}

double pass_seconds(const std::vector<PassCost>& passes, double samples) {
  const auto above =
      std::find_if(passes.begin(), passes.end(), [&](const PassCost& p) { return p.samples >= samples; });
  if (above == passes.begin()) return above->seconds * samples / above->samples;
  const PassCost& low = *(above - 1);
  if (above == passes.end()) return low.seconds * samples / low.samples;
  return low.seconds + (above->seconds - low.seconds) * (samples - low.samples) / (above->samples - low.samples);
}

Prediction predict(const std::optional<ErrorTrend>& law, const RunCosts& costs, const PredictedGoal& goal) {
  std::vector<double> seconds, spp, rmse;
  Imagination imagination(law, costs, goal);
  for (int i = 0; i < imagined_runs; ++i) {
    const ImaginedRun run = imagination.run();
    seconds.push_back(run.seconds);
    spp.push_back(run.spp);
    rmse.push_back(run.rmse);
  }
  Prediction prediction{range_of(std::move(seconds)), range_of(std::move(spp)), true, std::nullopt};
  if (law && prediction.spp.middle >= told_from) prediction.rmse = range_of(std::move(rmse));
  return prediction;
}

}  // namespace strahl
