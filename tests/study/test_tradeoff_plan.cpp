// SPDX-License-Identifier: MIT
// Which settings a trade-off study measures, what they are called, and a point's way into a file and back.
#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "errors.h"
#include "study/tradeoff/identity.h"
#include "study/tradeoff/json.h"
#include "study/tradeoff/plan.h"

namespace strahl::test {
namespace {

using Depths = std::vector<std::optional<int>>;

IntegratorSettings integrator(const std::string& name, int max_depth = -1) {
  IntegratorSettings settings;
  settings.name = name;
  settings.max_depth = max_depth;
  return settings;
}

TradeoffAxes all_tiers(const IntegratorSettings& settings) {
  TradeoffAxes axes;
  axes.precisions = {Precision::fast, Precision::stable, Precision::robust, Precision::fp64};
  axes.depths = default_depths(settings);
  return axes;
}

std::set<std::string> ids(const TradeoffPlan& plan) {
  std::set<std::string> result;
  for (const TradeoffSetting& setting : plan.settings) result.insert(setting.id());
  return result;
}

TEST_CASE("planes through the centre, each setting once, each program in a row") {
  const IntegratorSettings path = integrator("path", 8);
  const TradeoffPlan plan = plan_tradeoff(path, all_tiers(path), Precision::fp64, 4096);
  CHECK(plan.settings.size() == 4 * 2 * 5 + 2 * 2 * 5 + 5);
  CHECK(ids(plan).size() == plan.settings.size());
  CHECK(plan.centre == TradeoffSetting{Precision::robust, SamplerKind::sobol, 8, 256, false});
  CHECK(plan.reference == TradeoffSetting{Precision::fp64, SamplerKind::sobol, 8, 4096, false});
  CHECK(ids(plan).contains("robust-sobol-d2-64spp-specialised"));
  CHECK(ids(plan).contains("double-independent-d8-1spp-specialised"));
  CHECK(ids(plan).contains("robust-sobol-d8-256spp-generic"));
  CHECK_FALSE(ids(plan).contains("fast-sobol-d2-64spp-specialised"));
  int rows = 1;
  for (std::size_t i = 1; i < plan.settings.size(); ++i)
    rows += plan.settings[i].is_same_but_for_samples(plan.settings[i - 1]) ? 0 : 1;
  CHECK(rows == 4 * 2 + 2 * 2 + 1);
}

TEST_CASE("depths: below the scene's own and its own; no limit is the deepest") {
  CHECK(default_depths(integrator("path", 8)) == Depths{2, 4, 8});
  CHECK(default_depths(integrator("path", 3)) == Depths{2, 3});
  CHECK(default_depths(integrator("path", 1)) == Depths{1});
  CHECK(default_depths(integrator("whitted")) == Depths{2, 4, 8, -1});
  CHECK(default_depths(integrator("ao")) == Depths{std::nullopt});

  TradeoffAxes axes = all_tiers(integrator("path", 5));
  axes.depths = {-1, 7, 2};
  TradeoffPlan plan = plan_tradeoff(integrator("path", 5), axes, Precision::fp64, 64);
  CHECK(plan.centre.max_depth == -1);
  CHECK(plan.reference.max_depth == -1);
  CHECK(plan.centre.id() == "robust-sobol-dinf-256spp-specialised");
  axes.depths = {2, 3};
  plan = plan_tradeoff(integrator("path", 5), axes, Precision::fp64, 64);
  CHECK(plan.centre.max_depth == 3);
  CHECK(plan.reference.max_depth == 5);
}

TEST_CASE("axes are put in order; impossible ones are refused") {
  TradeoffAxes axes = all_tiers(integrator("ao"));
  axes.precisions = {Precision::fast};
  axes.samplers = {SamplerKind::independent, SamplerKind::independent};
  axes.spps = {16, 1, 16, 4};
  axes.generic = false;
  const TradeoffPlan plan = plan_tradeoff(integrator("ao"), axes, Precision::fp64, 64);
  REQUIRE(plan.settings.size() == 3);
  CHECK(plan.settings.front().id() == "fast-independent-1spp-specialised");
  CHECK(plan.settings.back().spp == 16);
  CHECK(plan.reference.sampler == SamplerKind::sobol);

  axes.depths = {2};
  CHECK_THROWS_AS(plan_tradeoff(integrator("ao"), axes, Precision::fp64, 64), UsageError);
  axes.depths = {};
  axes.spps = {0};
  CHECK_THROWS_AS(plan_tradeoff(integrator("ao"), axes, Precision::fp64, 64), UsageError);
  axes.spps = {};
  CHECK_THROWS_AS(plan_tradeoff(integrator("ao"), axes, Precision::fp64, 64), UsageError);
}

TEST_CASE("a point comes back from its file as it was, and only into its own study") {
  TradeoffPoint point;
  point.setting = {Precision::fp64, SamplerKind::independent, std::nullopt, 4, true};
  point.seeds = 3;
  point.seconds = {0.1, 0.2, 0.3, 1.0 / 3, 1};
  point.program = "0123456789abcdef";
  point.program_from_cache = true;
  point.error.mse = 1.0 / 7;
  point.error.mse_error = 0.01;
  point.error.variance = 0.1;
  for (const Metric metric : study_metrics())
    point.metrics.emplace_back(metric_name(metric),
                               metric == Metric::psnr ? std::numeric_limits<double>::infinity() : 0.5);
  point.unusual.invalid = 2;
  const std::string text = point_json(point, "this");
  const std::optional<TradeoffPoint> back = point_from_json(text, "this");
  REQUIRE(back);
  CHECK(back->setting == point.setting);
  CHECK(point_json(*back, "this") == text);
  CHECK_FALSE(point_from_json(text, "that"));
  CHECK_FALSE(point_from_json(text.substr(0, text.size() / 2), "this"));
  CHECK_FALSE(point_from_json("{}", "this"));
  std::string other = text;
  other.replace(other.find("\"double\""), 8, "\"triple\"");
  CHECK_FALSE(point_from_json(other, "this"));
}

TEST_CASE("identities say in what they differ") {
  const StudyIdentity three{{{"seeds", "3"}, {"size", "8 x 8"}}}, five{{{"seeds", "5"}, {"size", "8 x 8"}}};
  CHECK(three.difference_from(three.json()).empty());
  CHECK(five.difference_from(three.json()) == "the seeds (\"3\" there, \"5\" now)");
  CHECK(three.hash() != five.hash());
  CHECK(three.difference_from("no JSON") == "the seeds (not stated there)");
}

}  // namespace
}  // namespace strahl::test
