// SPDX-License-Identifier: MIT
// `strahl bench`: what a device is worth, as a table or JSON, beside an earlier one.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/distinct_files.h"
#include "cli/number_options.h"
#include "cli/output_file.h"
#include "cli/progress_bar.h"
#include "cli/scene_options.h"
#include "image/file_bytes.h"
#include "json_text.h"
#include "opencl/tuned_width.h"
#include "scene/loader.h"
#include "study/generated/scenes.h"
#include "study/tune.h"

namespace strahl::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* bench_footer = R"(
Rays through one scene in every precision that the device has: camera rays, shadow rays and diffuse bounces, by the code
that render uses; in turns, medians of five rounds. Memory: reads by a kernel, copies by the driver. Less than a minute.

Examples:
  strahl bench                                     the fastest GPU, else CPU
  strahl bench -d pocl --json before.json
  strahl bench -d pocl --compare before.json       how many times as fast as then, or as another device
  strahl bench --scene mesh.ply
  strahl bench -d pocl --tune                      which width of the tree suits the device; remembered

No canary is asked: times say nothing about answers, strahl selftest does.)";

struct BenchOptions {
  std::string device;
  std::string scene = "terrain-100000";
  std::string json;
  std::string compare;
  int pixels = 0;
  bool tune = false;
  bool quiet = false;
  bool no_progress = false;
};

Scene scene_of(const std::string& name) {
  if (name.find_first_of("./") == std::string::npos) return generated_scene(name);
  LoadedScene loaded = load_scene(name);
  say_diagnostics(loaded.warnings, false);
  add_missing_point_light(loaded.scene);
  return std::move(loaded.scene);
}

/// How --scene asks for what an earlier run calls `name`, in which a file's folder and ending are missing.
std::string scene_option(const std::string& name) {
  return is_generated_scene(name) ? "--scene " + name : "--scene with its file";
}

Json json_of(const DeviceBench& bench) {
  return {{"strahl", STRAHL_VERSION},
          {"device", bench.device},
          {"scene", bench.scene},
          {"primitives", bench.primitives},
          {"rays", bench.rays},
          {"mrays", bench.mrays},
          {"bandwidth", {{"read", bench.bandwidth.read}, {"copy", bench.bandwidth.copy}}},
          {"tree_seconds", bench.tree_seconds},
          {"program_seconds", bench.program_seconds},
          {"program_from_cache", bench.program_from_cache}};
}

constexpr int least_side = 16, most_side = 8192;

/// An earlier --json, or nothing.
class Base {
 public:
  explicit Base(const std::string& path) : path_(path) {
    if (path.empty()) return;
    try {
      json_ = Json::parse(read_file(path));
      device_ = json_.at("device").get<std::string>();
      scene_ = json_.at("scene").get<std::string>();
      primitives_ = json_.at("primitives").get<std::size_t>();
      const auto rays = json_.at("rays").at(ray_kind_name(RayKind::primary)).get<double>();
      side_ = static_cast<int>(std::lround(std::sqrt(std::clamp(rays, 0.0, 1.0 * most_side * most_side))));
      if (side_ < least_side || 1.0 * side_ * side_ != rays)
        throw InputError(fmt::format("{}: not what strahl bench --json writes: {} camera rays", path, rays));
    } catch (const Json::exception& error) {
      throw InputError(fmt::format("{}: not what strahl bench --json writes: {}", path, error.what()));
    }
  }

  void require_same_scene(const std::string& scene, std::size_t primitives) const {
    if (path_.empty()) return;
    if (scene_ != scene)
      throw InputError(
          fmt::format("{} is of the scene {}; only the same scene compares ({})", path_, scene_, scene_option(scene_)));
    if (primitives_ != primitives)
      throw InputError(
          fmt::format("{} is of another scene called {}, with {} primitives, and this one has {}; only the same scene "
                      "compares: measure it again with --json",
                      path_, scene_, primitives_, primitives));
  }

  /// The side of the picture whose rays both trace: `asked`, or 0 where nobody asked, without a base.
  [[nodiscard]] int side(int asked) const {
    if (path_.empty()) return asked;
    if (asked > 0 && asked != side_)
      throw InputError(
          fmt::format("{} is of {} x {} camera rays; only as many compare: leave --pixels out, or choose "
                      "--pixels {}",
                      path_, side_, side_, side_));
    return side_;
  }
  [[nodiscard]] bool is_there() const { return !path_.empty(); }
  [[nodiscard]] const std::string& device() const { return device_; }

  /// As ratio, of two programs that were both built or both loaded from the cache.
  [[nodiscard]] std::string program_ratio(const std::string& tier, double value, bool from_cache) const {
    const auto at = Json::json_pointer("/program_from_cache/" + tier);
    if (path_.empty() || !json_.contains(at) || json_.at(at) != from_cache) return {};
    return ratio("/program_seconds/" + tier, value, false);
  }

  /// "x1.25": times as fast; empty where the base has no such number.
  [[nodiscard]] std::string ratio(const std::string& pointer, double value, bool larger_is_better) const {
    const auto at = Json::json_pointer(pointer);
    if (path_.empty() || !json_.contains(at) || !json_.at(at).is_number()) return {};
    const double base = json_.at(at).get<double>();
    if (!(base > 0 && value > 0)) return {};
    return fmt::format("x{:.2f}", larger_is_better ? value / base : base / value);
  }

 private:
  std::string path_, device_, scene_;
  std::size_t primitives_ = 0;
  int side_ = 0;  ///< Of the square picture whose camera rays it traced.
  Json json_;
};

std::string row(const std::string& name, const std::vector<std::pair<std::string, std::string>>& cells, bool compared) {
  std::string text = fmt::format("{:<16}", name);
  for (const auto& [value, ratio] : cells) {
    text += fmt::format(" {:>9}", value);
    if (compared) text += fmt::format(" {:>7}", ratio);
  }
  return text + "\n";
}

std::string table(const DeviceBench& bench, const Base& base) {
  const bool compared = base.is_there();
  std::string text = fmt::format("{} · {}, {} primitives\n", bench.device, bench.scene, bench.primitives);
  if (compared) text += fmt::format("x: times as fast as {}\n", base.device());
  std::vector<std::pair<std::string, std::string>> cells;
  for (const std::string& tier : bench.tiers) cells.emplace_back(tier, "");
  text += row("Mrays/s", cells, compared);
  for (const RayKind kind : all_ray_kinds) {
    const std::string name = ray_kind_name(kind);
    cells.clear();
    for (const std::string& tier : bench.tiers) {
      const double value = bench.mrays.at(name).at(tier);
      cells.emplace_back(fmt::format("{:.2f}", value),
                         base.ratio(fmt::format("/mrays/{}/{}", name, tier), value, true));
    }
    text += row(name, cells, compared);
  }
  cells.clear();
  for (const std::string& tier : bench.tiers) {
    const double value = bench.program_seconds.at(tier);
    cells.emplace_back(fmt::format("{:.2f}", value),
                       base.program_ratio(tier, value, bench.program_from_cache.at(tier)));
  }
  text += row("program, s", cells, compared);
  cells.clear();
  for (const std::string& tier : bench.tiers)
    cells.emplace_back(bench.program_from_cache.at(tier) ? "loaded" : "built", "");
  text += row("", cells, compared);
  text += row("tree, s",
              {{fmt::format("{:.3f}", bench.tree_seconds), base.ratio("/tree_seconds", bench.tree_seconds, false)}},
              compared);
  text += row(
      "read, GB/s",
      {{fmt::format("{:.1f}", bench.bandwidth.read / 1e9), base.ratio("/bandwidth/read", bench.bandwidth.read, true)}},
      compared);
  text += row(
      "copy, GB/s",
      {{fmt::format("{:.1f}", bench.bandwidth.copy / 1e9), base.ratio("/bandwidth/copy", bench.bandwidth.copy, true)}},
      compared);
  return text;
}

std::string tuned_table(const Device& device, const std::vector<TunedTier>& tiers) {
  std::string text = device.info().text() + "\nMrays/s by the tree's width\n";
  for (const TunedTier& tier : tiers) {
    text += fmt::format("{:<16}", precision_name(tier.precision));
    for (const auto& [width, mrays] : tier.mrays)
      text += fmt::format(" {:>3}: {:.2f}{}", width, mrays, width == tier.best ? "*" : " ");
    text += "\n";
  }
  return text + "* the fastest\n";
}

ExitCode tune_device(const BenchOptions& options) {
  const Scene scene = scene_of(options.scene);
  const Device device = Device::open(options.device);
  std::vector<TunedTier> tiers;
  {
    ProgressBar bar("tune", !options.quiet && !options.no_progress);
    tiers = tune(device, scene, options.pixels,
                 [&bar](int done, int total) { bar.show(static_cast<double>(done) / total, "measuring"); });
  }
  print(tuned_table(device, tiers));
  for (const TunedTier& tier : tiers) remember_width(device, tier.precision, tier.best);
  print("remembered for this device and driver; strahl devices --clear-cache forgets\n");
  return ExitCode::ok;
}

ExitCode bench(const BenchOptions& options) {
  if (options.tune) return tune_device(options);
  require_distinct({{"--json", options.json}}, {{"--scene", options.scene}, {"--compare", options.compare}});
  if (!options.json.empty() && options.json != "-") require_writable(options.json);
  const Base base(options.compare);
  const Scene scene = scene_of(options.scene);
  require_distinct({{"--json", options.json}}, scene_files(options.scene, scene.files));
  base.require_same_scene(scene.name, primitives_of(scene));
  const int side = base.side(options.pixels);
  const Device device = Device::open(options.device);
  DeviceBench result;
  {
    ProgressBar bar("bench", !options.quiet && !options.no_progress);
    result = bench_device(device, scene, side,
                          [&bar](int done, int total) { bar.show(static_cast<double>(done) / total, "measuring"); });
  }
  if (options.json != "-") print(table(result, base));
  if (!options.json.empty()) write_text(options.json, json_text(json_of(result)));
  return ExitCode::ok;
}

}  // namespace

Command add_bench(CLI::App& app) {
  const auto options = std::make_shared<BenchOptions>();
  add_device_option(app, options->device);
  app.add_option("--scene", options->scene, "A file, or a generated scene, such as sphereflake-5")
      ->type_name("SCENE")
      ->capture_default_str();
  app.add_option("--json", options->json, "The numbers for programs; - for standard output, in place of the table")
      ->type_name("FILE");
  app.add_option("--compare", options->compare, "An earlier --json: how many times as fast")->type_name("FILE");
  require_whole(app.add_option("--pixels", options->pixels,
                               "The picture's side; default: that of --compare, else what the device does in an "
                               "eighth of a second, 1024 at the most"))
      ->type_name("N")
      ->check(CLI::Range(least_side, most_side).description(""));
  app.add_flag("--tune", options->tune,
               "Measure widths of the tree instead, and remember the fastest of each precision")
      ->excludes("--json")
      ->excludes("--compare");
  app.add_flag("-q,--quiet", options->quiet, "Say nothing but the table");
  app.add_flag("--no-progress", options->no_progress, "No progress bar");
  app.footer(bench_footer);
  return [options] { return bench(*options); };
}

}  // namespace strahl::cli
