// SPDX-License-Identifier: MIT
#include "cli/dry_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/console.h"
#include "cli/output_file.h"
#include "render/sampling.h"

namespace strahl::cli {
namespace {

constexpr int first_spp = 4;         ///< The fewest that tell an error.
constexpr double pilot_share = 0.3;  ///< Seconds, for the second part of the pilot.

struct Prediction {
  double spp = 0, seconds = 0;
  std::optional<double> rmse;
};

/// Two short renders: the second says what a sample takes, both together how the error falls with their number.
struct Pilot {
  double setup = 0;           ///< Seconds from the start of the process to the first sample.
  double sample_seconds = 0;  ///< One of every pixel.
  double finish = 0;          ///< From the last sample to the picture.
  double spp = 0, rmse = 0;
  double exponent = 0.5;  ///< rmse ~ spp^-exponent

  [[nodiscard]] double rmse_at(double n) const { return rmse * std::pow(spp / n, exponent); }
  [[nodiscard]] double seconds_at(double n, double end) const { return setup + n * sample_seconds + finish + end; }
};

Pilot pilot_of(Renderer& renderer, const Invocation& invocation) {
  Pilot pilot;
  pilot.setup = invocation.seconds();
  RenderGoal goal;
  const int first = std::max(first_spp, renderer.samples_at_once());
  goal.spp = first;
  const RenderResult few = renderer.render({}, goal);
  const double few_seconds = few.stats.seconds.kernel / first;
  goal.spp =
      std::clamp(static_cast<int>(pilot_share / few_seconds) / first * first, 2 * first, std::max(64, 2 * first));
  const RenderResult more = few_seconds * first > 2 * pilot_share ? few : renderer.render({}, goal);
  pilot.spp = more.stats.spp;
  pilot.sample_seconds = more.stats.seconds.kernel / pilot.spp;
  pilot.finish = more.stats.seconds.readback + more.stats.seconds.error;
  if (!more.error || !few.error) return pilot;
  pilot.rmse = more.error->rmse;
  if (pilot.spp > first && pilot.rmse > 0)
    pilot.exponent = std::clamp(std::log(few.error->rmse / pilot.rmse) / std::log(pilot.spp / first), 0.45, 1.0);
  return pilot;
}

Prediction predict(const Pilot& pilot, const RenderGoal& goal, const std::optional<double>& time, int scene_spp,
                   double end) {
  double spp = goal.spp.value_or(time || goal.max_error ? max_spp : scene_spp);
  if (goal.max_error && pilot.rmse > 0)
    spp = std::min(spp,
                   std::max(2.0 * first_spp, pilot.spp * std::pow(pilot.rmse / *goal.max_error, 1 / pilot.exponent)));
  if (time) spp = std::min(spp, std::max(1.0, (*time - pilot.seconds_at(0, end)) / pilot.sample_seconds));
  Prediction prediction{spp, pilot.seconds_at(spp, end), std::nullopt};
  if (spp >= first_spp) prediction.rmse = pilot.rmse_at(spp);
  return prediction;
}

}  // namespace

ExitCode dry_run(Renderer& renderer, const RenderOptions& options, const Invocation& invocation, int scene_spp,
                 double end_seconds) {
  const Pilot pilot = pilot_of(renderer, invocation);
  std::optional<double> time;
  if (options.goal.time) time = duration_seconds(*options.goal.time);
  const Prediction p = predict(pilot, goal_of(options, invocation, end_seconds), time, scene_spp, end_seconds);
  const std::string error = p.rmse ? fmt::format("RMSE {:.2g}", *p.rmse) : "error not known with fewer than 4 samples";
  print(fmt::format("{:.2f} s expected, {:.0f} samples a pixel, {}\n", p.seconds, p.spp, error));
  if (!options.stats.empty())
    write_text(
        options.stats,
        nlohmann::ordered_json{
            {"predicted",
             {{"seconds", p.seconds}, {"spp", p.spp}, {"rmse", p.rmse ? nlohmann::ordered_json(*p.rmse) : nullptr}}},
            {"pilot", {{"spp", pilot.spp}, {"sample_seconds", pilot.sample_seconds}, {"exponent", pilot.exponent}}}}
                .dump(2) +
            "\n");
  return ExitCode::ok;
}

}  // namespace strahl::cli
