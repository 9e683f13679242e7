// SPDX-License-Identifier: MIT
// `strahl explain`: which effects a scene calls for, where, which program that makes, and what each effect costs.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/integrators_text.h"
#include "cli/kernel_options.h"
#include "cli/number_options.h"
#include "cli/progress_bar.h"
#include "cli/scene_options.h"
#include "cli/scene_overrides.h"
#include "json_text.h"
#include "kinds/integrators.h"
#include "opencl/device.h"
#include "opencl/program.h"
#include "opencl/tuned_width.h"
#include "program/features.h"
#include "program/path_lanes.h"
#include "program/program_text.h"
#include "render/shown_scene.h"
#include "render/traversal_choice.h"
#include "scene/integrator_advice.h"
#include "study/effect_costs.h"
#include "study/integrator_costs.h"

namespace strahl::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* explain_footer = R"(
Lists every effect, on or off, with the scene element that called for it, and the hash of the rendering program. The
program depends on the number of lanes: that of --lanes, else what fits the device, else (no device at all) 1.

--cost builds the program once more without each effect, and renders without it: bytes of the program's binary, time to
build it with nothing cached, time of a frame's kernels. Programs take turns; medians are told. It takes a minute or so.
Then it renders a little by each integrator, at a low resolution: what it would miss, and how long the picture would take
until its error is 1 % of its mean (--error-share), with an interval. --cost effects, --cost integrators: one of both.

Examples:
  strahl explain scene.xml
  strahl explain scene.xml --integrator normals --aov depth
  strahl explain scene.xml --cost
  strahl explain scene.xml --cost integrators --pilot 5
  strahl explain scene.xml --json --lanes 8)";

struct ExplainOptions {
  SceneOptions scene;
  SceneOverrides overrides;
  KernelOptions kernel;
  std::string device;
  std::optional<std::string> cost;
  int rounds = 3;
  double pilot_seconds = 2;
  double error_share = 0.01;
  std::vector<std::string> among;
  bool json = false;
  std::vector<const CLI::Option*> of_effects, of_integrators;  ///< Without effect where the other alone is measured.
};

struct Lanes {
  int count = 1;
  int tree = 4;
  std::string why;
};

Lanes lanes_for(const ExplainOptions& options, const RenderSettings& settings, const Scene& scene) {
  if (settings.lanes || settings.bvh_width) {
    const Width width = wide_enough(width_of(settings, 1), scene, settings);
    return {width.lanes, width.tree, settings.lanes ? "--lanes" : "--bvh-width"};
  }
  try {
    const Device device = Device::open(options.device, {settings.precision == Precision::fp64});
    const Width width = wide_enough(width_on(device, settings), scene, settings);
    return {width.lanes, width.tree, "for " + device.info().text()};
  } catch (const NoDeviceError&) {
    if (!options.device.empty()) throw;  // It was asked for by name.
    return {1, 4, "no OpenCL device; --lanes states another number"};
  }
}

/// What there is to tell.
struct Explained {
  RenderSettings settings;
  Features features;
  std::string program;
  Lanes lanes;
  std::optional<EffectCosts> costs;
  std::optional<IntegratorCosts> integrators;
  std::vector<Advice> advice;
};

std::string frame_text(const VariantStudy& study) {
  return fmt::format("{} x {}, {} of {} samples a pixel", study.width, study.height, study.spp, study.scene_spp);
}

std::string cost_text(const EffectCost& cost) {
  if (!cost.needed.empty()) return "needed";
  const std::string frame = cost.frame_needed.empty() ? fmt::format("{:+9.2f} ms {:+6.1f} %", 1e3 * cost.kernel_seconds,
                                                                    100 * cost.kernel_share)
                                                      : cost.frame_needed;
  return fmt::format("{:+8.1f} KiB {:+7.0f} ms {}", cost.program_bytes / 1024, 1e3 * cost.build_seconds, frame);
}

std::string text_of(const Explained& all) {
  std::string text =
      fmt::format("program {} · {} · {} lane{} ({})\n", all.program, precision_name(all.settings.precision),
                  all.lanes.count, all.lanes.count == 1 ? "" : "s", all.lanes.why);
  if (all.costs) {
    const VariantTimes& own = all.costs->study.variants.front();
    text += fmt::format(
        "binary {:.1f} KiB · built in {:.0f} ms with nothing cached · kernels of a frame {:.2f} ms ({})\n"
        "costs: what an effect adds to binary, building and a frame; medians of {} builds and {} frames in turns\n",
        static_cast<double>(own.bytes) / 1024, 1e3 * own.build(), 1e3 * own.kernel(), frame_text(all.costs->study),
        own.build_seconds.size(), own.kernel_seconds.size());
  }
  std::vector<std::array<std::string, 4>> rows;
  std::array<std::size_t, 4> widths{};
  for (const FeatureReport& feature : all.features.report) {
    std::string cost;
    if (all.costs && feature.on) cost = cost_text(all.costs->effects.at(feature.name));
    rows.push_back({feature.name, cost, feature.why, feature.where.text()});
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], rows.back()[i].size());
  }
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::string line = all.features.report[i].on ? "on " : "off";
    for (std::size_t column = 0; column < widths.size(); ++column)
      if (widths[column] > 0) line += fmt::format("  {:<{}}", rows[i][column], widths[column]);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  for (const Advice& advice : all.advice)
    text += fmt::format("advice: integrator {} finds {}  {}\n", advice.integrator, advice.why, advice.where.text());
  if (all.integrators) text += integrators_text(*all.integrators);
  return text;
}

Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }

Json cost_json(const EffectCost& cost) {
  if (!cost.needed.empty()) return {{"needed", cost.needed}};
  const bool timed = cost.frame_needed.empty();
  return {{"needed", nullptr},
          {"program_bytes", cost.program_bytes},
          {"build_seconds", cost.build_seconds},
          {"frame_needed", text_or_null(cost.frame_needed)},
          {"kernel_seconds", timed ? Json(cost.kernel_seconds) : Json(nullptr)},
          {"kernel_share", timed ? Json(cost.kernel_share) : Json(nullptr)}};
}

Json costs_json(const EffectCosts& costs) {
  const VariantTimes& own = costs.study.variants.front();
  return {{"program_bytes", own.bytes},         {"build_seconds", own.build()},
          {"kernel_seconds", own.kernel()},     {"width", costs.study.width},
          {"height", costs.study.height},       {"spp", costs.study.spp},
          {"scene_spp", costs.study.scene_spp}, {"builds", own.build_seconds.size()},
          {"frames", own.kernel_seconds.size()}};
}

std::string json_of(const Explained& all) {
  Json list = Json::array();
  for (const FeatureReport& feature : all.features.report) {
    Json row = {{"name", feature.name},
                {"on", feature.on},
                {"why", feature.why},
                {"where", text_or_null(feature.where.text())}};
    if (all.costs) row["cost"] = feature.on ? cost_json(all.costs->effects.at(feature.name)) : Json(nullptr);
    list.push_back(row);
  }
  Json json = {{"program", all.program},
               {"features", list},
               {"precision", precision_name(all.settings.precision)},
               {"lanes", all.lanes.count}};
  if (all.costs) json["cost"] = costs_json(*all.costs);
  json["advice"] = Json::array();
  for (const Advice& advice : all.advice)
    json["advice"].push_back(
        {{"integrator", advice.integrator}, {"finds", advice.why}, {"where", text_or_null(advice.where.text())}});
  if (all.integrators) json["integrators"] = integrators_json(*all.integrators);
  return json_text(json);
}

IntegratorCosts integrators_of(const ExplainOptions& options, const Scene& scene, const RenderSettings& settings) {
  const Device device = Device::open(options.device, {settings.precision == Precision::fp64});
  ProgressBar bar("integrators", !options.scene.quiet && !options.scene.no_progress);
  return measure_integrators(device, scene, settings, options.pilot_seconds, options.error_share,
                             [&](double share) { bar.show(share, "pilots"); },
                             {options.among.begin(), options.among.end()});
}

EffectCosts costs_of(const ExplainOptions& options, const Scene& scene, const RenderSettings& settings) {
  const Device device = Device::open(options.device, {settings.precision == Precision::fp64});
  ProgressBar bar("cost", !options.scene.quiet && !options.scene.no_progress);
  VariantRounds rounds;
  rounds.builds = options.rounds;
  rounds.frames = 3 * options.rounds;
  return measure_effects(device, scene, settings, rounds, [&](double share) { bar.show(share, "building"); });
}

void require_used(const std::vector<const CLI::Option*>& given, const char* measured) {
  for (const CLI::Option* option : given)
    if (option->count() > 0)
      throw UsageError(fmt::format("{}: nothing of that is measured by --cost {}; leave one of both out",
                                   option->get_name(), measured));
}

/// What light does not decide has no error to be compared at.
void require_light_transport(const std::vector<std::string>& among) {
  const std::vector<std::string> known = light_transport_names();
  for (const std::string& name : among)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw UsageError(
          fmt::format("--among: integrator {} does not follow light, so there is nothing to compare; {} do", name,
                      fmt::join(known, ", ")));
}

ExitCode explain(const ExplainOptions& options) {
  require_light_transport(options.among);
  const auto is_asked = [&](const char* of) {
    return options.cost && (*options.cost == of || *options.cost == "both");
  };
  if (options.cost && !is_asked("effects")) require_used(options.of_effects, "integrators");
  if (options.cost && !is_asked("integrators")) require_used(options.of_integrators, "effects");
  if (is_asked("effects")) keep_drivers_from_caching();
  Explained all;
  all.settings = settings_of(options.kernel);
  double load_seconds = 0;
  Scene scene = load(options.scene, load_seconds);
  apply(options.overrides, scene);
  all.advice = integrator_advice(scene);
  if (is_asked("integrators")) all.integrators = integrators_of(options, scene, all.settings);
  scene = shown_scene(std::move(scene), all.settings);
  all.features = features_of(scene, all.settings);
  all.lanes = lanes_for(options, all.settings, scene);
  const int paths = path_lanes(all.features, all.settings, all.lanes.count);
  const bool has_tree =
      choose_traversal(scene, all.features, all.settings, {all.lanes.count, all.lanes.tree}, paths).has_tree;
  all.program = program_hash(program_source(kinds::integrator(scene.integrator.name).kernel(), all.features,
                                            all.settings.precision, all.lanes.count, all.lanes.tree, has_tree, paths));
  if (is_asked("effects")) all.costs = costs_of(options, scene, all.settings);
  print(options.json ? json_of(all) : text_of(all));
  return ExitCode::ok;
}

}  // namespace

Command add_explain(CLI::App& app) {
  const auto options = std::make_shared<ExplainOptions>();
  add_scene_options(app, options->scene);
  add_device_option(app, options->device);
  app.add_flag("--json", options->json, "For programs");
  CLI::Option* cost =
      app.add_option("--cost", options->cost,
                     "Measure what each effect adds to the program and to a frame, and what each integrator takes")
          ->type_name("[effects|integrators]")
          ->expected(0, 1)
          ->default_str("both")
          ->check(CLI::IsMember({"both", "effects", "integrators"}).description(""));
  CLI::Option* rounds =
      app.add_option("--rounds", options->rounds, "Builds of every program, and a third of the frames");
  require_whole(rounds)->needs(cost)->type_name("N")->capture_default_str()->check(CLI::Range(1, 100).description(""));
  CLI::Option* pilot =
      app.add_option("--pilot", options->pilot_seconds, "Seconds of each integrator's pilot, building aside");
  require_between(pilot, 0.01, 3600)->needs(cost)->type_name("SECONDS")->capture_default_str();
  CLI::Option* among =
      app.add_option("--among", options->among, "Integrators to compare, of light transport; all of them by default");
  among->needs(cost)
      ->type_name("NAME,...")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(kinds::integrator_names()).description(""));
  CLI::Option* share = app.add_option("--error-share", options->error_share,
                                      "The error that integrators are compared at, over the mean");
  require_between(share, 1e-6, 1)->needs(cost)->type_name("SHARE")->capture_default_str();
  options->of_effects = {rounds};
  options->of_integrators = {pilot, among, share};
  add_scene_overrides(app, options->overrides);
  add_kernel_options(app, options->kernel);
  add_program_options(app, options->kernel);
  app.footer(explain_footer);
  return [options] { return explain(*options); };
}

}  // namespace strahl::cli
