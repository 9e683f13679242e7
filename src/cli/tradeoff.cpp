// SPDX-License-Identifier: MIT
// `strahl tradeoff`: what error costs in time on a scene, as a report, a table and JSON.
#include "study/tradeoff/tradeoff.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <set>

#include "cli/canary.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/distinct_files.h"
#include "cli/interrupt.h"
#include "cli/number_options.h"
#include "cli/progress_bar.h"
#include "cli/scene_options.h"
#include "cli/scene_overrides.h"
#include "cli/summary.h"
#include "cli/tradeoff_table.h"
#include "image/image_io.h"
#include "kinds/integrators.h"
#include "render/limitations.h"
#include "render/renderer.h"
#include "settings/sampler_name.h"
#include "settings/sampling.h"
#include "study/tradeoff/json.h"
#include "study/tradeoff/store.h"

namespace strahl::cli {
namespace {

constexpr const char* tradeoff_footer = R"(
Renders the scene in every precision, with every sampler, some depths and numbers of samples, each with several seeds,
and holds the pictures against one reference in double. DIR gets report.html (open it in a browser), tradeoff.json,
tradeoff.csv, the reference and all pictures. Interrupted, the same command goes on where it was.

Examples:
  strahl tradeoff scene.xml                          writes scene.tradeoff/report.html here
  strahl tradeoff scene.xml -o study --width 320 --seeds 8
  strahl tradeoff scene.xml --precision fast,robust --spp 1,4,16 --depth 2,8 --sampler sobol --no-generic
  strahl tradeoff scene.xml --reference converged.exr --json

docs/tradeoff.md defines every number.)";

constexpr int default_width = 128;
/// So that its variance is below a tenth of that of the best point, with a sampler whose error falls as 1/sqrt.
constexpr int reference_samples_a_sample = 16;

struct TradeoffCommand {
  SceneOptions scene;
  std::string device;
  std::string folder;
  std::string reference;
  std::vector<std::string> precisions, samplers;
  std::vector<int> spps, depths;
  std::optional<int> reference_spp, width;
  int seeds = 3;
  bool no_generic = false, no_canary = false, restart = false, json = false;
};

/// The precisions to measure, the reference's, and how long loops may be in each of them.
struct Tiers {
  std::vector<Precision> measured;
  Precision reference = Precision::fp64;
  std::map<Precision, std::optional<std::uint64_t>> loop_turns;
};

bool is_trusted(const Device& device, Precision precision, bool no_canary, Tiers& tiers) {
  if (no_canary) return precision != Precision::fp64 || device.info().fp64;
  const TierVerdict verdict = tier_verdict(device, precision);
  tiers.loop_turns[precision] = verdict.loop_turns;
  return verdict.verdict != Verdict::refused;
}

std::string why_untrusted(const Device& device, Precision precision) {
  if (precision == Precision::fp64 && !device.info().fp64) return "has no double precision";
  return fmt::format("cannot keep what precision {} promises", precision_name(precision));
}

Device open_device(const TradeoffCommand& command) {
  bool needs_fp64 = false;
  for (const std::string& name : command.precisions) needs_fp64 |= precision_from_name(name) == Precision::fp64;
  return Device::open(command.device, {needs_fp64});
}

Tiers tiers_of(const Device& device, const TradeoffCommand& command) {
  Tiers tiers;
  for (const std::string& name : command.precisions) {
    const Precision precision = precision_from_name(name);
    if (!is_trusted(device, precision, command.no_canary, tiers))
      static_cast<void>(trusted_tier(device, precision));  // Throws, and says why.
    tiers.measured.push_back(precision);
  }
  for (const Precision precision : {Precision::fast, Precision::stable, Precision::robust, Precision::fp64}) {
    if (!command.precisions.empty()) break;
    if (is_trusted(device, precision, command.no_canary, tiers))
      tiers.measured.push_back(precision);
    else
      say(fmt::format("strahl: warning: {} {}: left out", device.info().text(), why_untrusted(device, precision)));
  }
  if (command.reference.empty() && !is_trusted(device, Precision::fp64, command.no_canary, tiers)) {
    tiers.reference = Precision::robust;
    std::string more;
    if (!command.no_canary) {
      const TierChoice choice = trusted_tier(device, {});
      tiers.reference = choice.tier.precision;
      tiers.loop_turns[tiers.reference] = choice.tier.loop_turns;
      if (!choice.instead.empty()) more = "; " + choice.instead;
    }
    say(fmt::format("strahl: warning: {} {}: the reference is {}{}", device.info().text(),
                    why_untrusted(device, Precision::fp64), precision_name(tiers.reference), more));
  }
  return tiers;
}

/// The whole picture, as wide as was asked for, as the reference is, or as is quick.
void resize(const TradeoffCommand& command, Scene& scene) {
  show_whole_picture(scene.film);
  SceneOverrides overrides;
  overrides.width = command.width.value_or(std::min(scene.film.width, default_width));
  if (!command.reference.empty() && !command.width) {
    const Image reference = read_image(command.reference);
    overrides.width = reference.width;
    overrides.height = reference.height;
  }
  apply(overrides, scene);
}

TradeoffPlan plan_of(const TradeoffCommand& command, const Scene& scene, const Tiers& tiers) {
  TradeoffAxes axes;
  axes.precisions = tiers.measured;
  if (!command.samplers.empty()) axes.samplers.clear();
  for (const std::string& name : command.samplers) axes.samplers.push_back(sampler_from_name(name));
  axes.depths = default_depths(scene.integrator);
  if (!command.depths.empty()) axes.depths.assign(command.depths.begin(), command.depths.end());
  for (const int depth : command.depths)
    if (depth < -1) throw UsageError(fmt::format("--depth {}: -1 is no limit, and less than that is none", depth));
  if (!command.spps.empty()) axes.spps = command.spps;
  axes.generic = !command.no_generic;
  const std::int64_t most = *std::max_element(axes.spps.begin(), axes.spps.end());
  const int reference_spp = command.reference_spp.value_or(
      static_cast<int>(std::min<std::int64_t>(most * reference_samples_a_sample, Renderer::most_samples(scene, {}))));
  return plan_tradeoff(scene.integrator, axes, tiers.reference, reference_spp);
}

void warn_of_samples(const TradeoffStudy& study) {
  UnusualSamples all;
  for (const TradeoffPoint& point : study.points) all += point.unusual;
  all.weak_branches = 0;  // Each is below what anybody sees.
  if (all == UnusualSamples{}) return;
  cli::warn_of_samples(all);
  say("strahl: tradeoff.json says in which points");
}

/// Throws UsageError where the study would write over the scene or the reference.
void require_distinct_study(const TradeoffCommand& command, const std::string& folder, const Scene& scene) {
  std::vector<NamedFile> inputs = scene_files(command.scene.path, scene.files);
  inputs.push_back({"--reference", command.reference});
  std::vector<NamedFile> outputs;
  const std::filesystem::path study(folder);
  for (const std::string& name : study_file_names())
    outputs.push_back({"the study's " + name, (study / name).string()});
  std::set<std::string> names;
  for (const NamedFile& input : inputs) names.insert(std::filesystem::path(input.path).filename().string());
  for (const std::string& name : names)  // Of the points' many files the one that has an input's name.
    if (const std::filesystem::path path = study / study_points_name / name; std::filesystem::is_regular_file(path))
      outputs.push_back({"a point of the study", path.string()});
  require_distinct(outputs, inputs);
}

ExitCode tradeoff(const TradeoffCommand& command, const Invocation& invocation) {
  double load_seconds = 0;
  Scene scene = load(command.scene, load_seconds);
  const std::string folder = command.folder.empty() ? scene.name + ".tradeoff" : command.folder;
  require_distinct_study(command, folder, scene);
  resize(command, scene);
  for (const Diagnostic& warning : limitations(scene)) say(warning.text());
  const Device device = open_device(command);
  const Tiers tiers = tiers_of(device, command);
  TradeoffOptions options;
  options.plan = plan_of(command, scene, tiers);
  options.seeds = command.seeds;
  options.reference_file = command.reference;
  options.folder = folder;
  options.restart = command.restart;
  options.scene_path = command.scene.path;
  options.command = invocation.command_line;
  options.loop_turns = tiers.loop_turns;

  const InterruptGuard guard;
  TradeoffStudy study;
  {
    ProgressBar bar("tradeoff", !command.scene.quiet && !command.scene.no_progress);
    study = study_tradeoff(device, scene, options, [&](const TradeoffProgress& progress) {
      bar.show(progress.share, progress.what);
      return !guard.interrupted();
    });
  }
  const std::size_t total = options.plan.settings.size();
  if (!study.complete) {
    say(fmt::format("strahl: interrupted with {} of {} points measured; the same command goes on from there",
                    study.points.size(), total));
    return guard.exit_code();
  }
  warn_of_samples(study);
  print(command.json ? tradeoff_json(study) : tradeoff_table(study));
  if (!command.scene.quiet)
    say(fmt::format("{:.1f} s · {}/report.html · {} points{} · {}×{} · {}", invocation.seconds(), options.folder, total,
                    study.taken_over > 0 ? fmt::format(", {} of them taken over", study.taken_over) : "",
                    scene.film.width, scene.film.height, study.device));
  return ExitCode::ok;
}

template <class Values>
CLI::Option* add_axis(CLI::App& app, const char* name, Values& values, const char* type, const std::string& what) {
  return app.add_option(name, values, what)
      ->type_name(type)
      ->delimiter(',')
      ->allow_extra_args(false)
      ->group("What is varied");
}

std::vector<std::string> names_with_depth() {
  std::vector<std::string> names;
  for (const std::string& name : kinds::integrator_names())
    if (kinds::integrator(name).has_depth()) names.push_back(name);
  return names;
}

}  // namespace

Command add_tradeoff(CLI::App& app, const Invocation& invocation) {
  const auto command = std::make_shared<TradeoffCommand>();
  add_scene_options(app, command->scene);
  add_device_option(app, command->device);
  app.add_option("-o,--output", command->folder, "Folder of the study; default: the scene's name with .tradeoff")
      ->type_name("DIR");
  require_whole(app.add_option("--width", command->width,
                               "Of each picture, in pixels; default: the reference's, or the scene's up to 128"))
      ->type_name("N")
      ->check(CLI::Range(16, 65536).description(""));
  require_whole(app.add_option("--seeds", command->seeds, "Pictures of each setting: what their spread is measured by"))
      ->type_name("N")
      ->capture_default_str()
      ->check(CLI::Range(2, 1000).description(""));
  CLI::Option* reference =
      app.add_option("--reference", command->reference, "Picture to measure against, in place of one rendered here")
          ->type_name("FILE");
  require_whole(app.add_option("--reference-spp", command->reference_spp,
                               "Samples per pixel of the reference; default: 16 times the most"))
      ->type_name("N")
      ->check(CLI::Range(1, max_spp).description(""))
      ->excludes(reference);
  add_axis(app, "--precision", command->precisions, "LIST", "fast, stable, robust, double; default: all");
  add_axis(app, "--sampler", command->samplers, "LIST", "sobol, independent, centre; default: sobol,independent");
  require_whole(add_axis(app, "--spp", command->spps, "LIST", "Samples per pixel; default: 1,4,16,64,256"));
  require_whole(add_axis(app, "--depth", command->depths, "LIST",
                         fmt::format("max_depth of {}; default: 2,4,8 below the scene's own, and that",
                                     fmt::join(names_with_depth(), ", "))));
  app.add_flag("--no-generic", command->no_generic, "Leave out the program that holds every effect")
      ->group("What is varied");
  app.add_flag("--no-canary", command->no_canary, "Trust the device's arithmetic without asking it");
  app.add_flag("--restart", command->restart, "Give up another study that the folder holds");
  app.add_flag("--json", command->json, "Print tradeoff.json in place of the table");
  app.footer(tradeoff_footer);
  return [command, &invocation] { return tradeoff(*command, invocation); };
}

}  // namespace strahl::cli
