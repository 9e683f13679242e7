// SPDX-License-Identifier: MIT
#include "cli/dry_run.h"

#include <nlohmann/json.hpp>

#include "cli/console.h"
#include "cli/output_file.h"
#include "json_text.h"
#include "render/rounding_pilot.h"
#include "stopwatch.h"

namespace strahl::cli {
namespace {

using Json = nlohmann::ordered_json;

/// most_spp: that the film holds.
PredictedGoal goal_from(const RenderOptions& options, int scene_spp, int most_spp) {
  PredictedGoal goal;
  const bool is_open = options.goal.time || options.goal.max_error;
  goal.spp = options.overrides.spp.value_or(is_open ? most_spp : scene_spp);
  goal.max_error = options.goal.max_error;
  if (options.goal.time) goal.seconds = duration_seconds(*options.goal.time);
  return goal;
}

/// The dry run itself leaves the program and the canary's answers in the caches, so that the render only loads them.
void set_start(const Renderer& renderer, const Preparation& preparation, double seconds, RunCosts& costs) {
  costs.start = seconds;
  const std::optional<double> built = renderer.build_seconds();
  if (!built) return;
  const Stopwatch loading;
  const double reload = renderer.load_program_again() ? loading.seconds() : 0;
  costs.start = std::max(0.0, seconds - *built - preparation.canary_seconds);
  costs.start_more = 2 * reload + preparation.canary_seconds;
}

/// None where a sample was not finite: such samples come in the render as well, and no error is told of them.
std::optional<ErrorTrend> law_of(const Pilot& pilot) {
  if (pilot.looks.empty() || pilot.not_finite > 0) return std::nullopt;
  return error_trend(pilot.looks, pilot.common_spread);
}

void set_pilot(const Pilot& pilot, const Preparation& preparation, const PredictedGoal& goal, RunCosts& costs) {
  costs.passes = pilot.passes;
  costs.spread = pilot.spread;
  costs.look = pilot.look_seconds;
  costs.end = pilot.look_seconds + preparation.end_seconds;
  costs.extra_share = goal.seconds ? 0 : rounding_share;
}

Json range_json(const Range& range) { return {{"low", range.low}, {"high", range.high}}; }

Json json_of(const Prediction& p, const Pilot& pilot, const std::optional<ErrorTrend>& law) {
  const auto known = [&p](const Json& json) { return p.has_end ? json : Json(nullptr); };
  return {{"predicted",
           {{"seconds", known(p.seconds.middle)},
            {"spp", known(p.spp.middle)},
            {"rmse", p.rmse ? Json(p.rmse->middle) : Json(nullptr)},
            {"confidence", prediction_confidence},
            {"seconds_interval", known(range_json(p.seconds))},
            {"spp_interval", known(range_json(p.spp))},
            {"rmse_interval", p.rmse ? range_json(*p.rmse) : Json(nullptr)}}},
          {"pilot",
           {{"spp", pilot.passes.back().samples},
            {"sample_seconds", pilot.passes.back().seconds / pilot.passes.back().samples},
            {"exponent", law ? Json(law->exponent / 2) : Json(nullptr)},
            {"seconds", pilot.seconds},
            {"share", pilot.share}}}};
}

}  // namespace

ExitCode dry_run(Renderer& renderer, const RenderOptions& options, const Invocation& invocation,
                 const Preparation& preparation) {
  const PredictedGoal goal = goal_from(options, preparation.scene_spp, renderer.most_samples());
  RunCosts costs;
  set_start(renderer, preparation, invocation.seconds(), costs);
  const bool only_error_ends_it = goal.max_error && !goal.seconds && !options.overrides.spp;
  const auto has_end = [&](const std::optional<ErrorTrend>& law) { return law || !only_error_ends_it; };
  const Pilot pilot = run_pilot(renderer, goal.spp, [&](const Pilot& so_far) {
    const std::optional<ErrorTrend> law = law_of(so_far);
    // Without an end what has been measured tells nothing of the time; a law may come of more samples.
    if (so_far.passes.empty() || (so_far.not_finite > 0 && !has_end(law))) return pilot_seconds(0);
    RunCosts known = costs;
    set_pilot(so_far, preparation, goal, known);
    return pilot_seconds(predict(law, known, goal).seconds.low);
  });
  set_pilot(pilot, preparation, goal, costs);
  const std::optional<ErrorTrend> law = law_of(pilot);
  Prediction prediction = predict(law, costs, goal);
  prediction.has_end = has_end(law);
  if (options.stats != "-") print(prediction_text(prediction, pilot));
  if (!options.scene.quiet && options.kernel.asks_for("numeric_error"))
    say("strahl: the prediction is without --aov numeric_error, which is traced once after the last sample");
  if (!options.stats.empty()) write_text(options.stats, json_text(json_of(prediction, pilot, law)));
  return ExitCode::ok;
}

}  // namespace strahl::cli
