// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "bench/commands.h"
#include "bench/traversal_report.h"
#include "image/atomic_file.h"
#include "study/generated/scenes.h"

namespace strahl::bench {
namespace {

struct TraversalCommand {
  TraversalOptions what;
  std::vector<std::string> kinds, tiers;
  std::string device;
  std::string json;
  std::string report;
};

void write(const std::filesystem::path& path, const std::string& text) {
  AtomicFile file(path.string());
  file.write(text);
  file.commit();
}

/// FOLDER/NAME.md, and the plots beside it.
void write_report(const Traversal& traversal, const std::string& folder) {
  std::filesystem::create_directories(folder);
  const std::map<std::string, std::string> plots = traversal_plots(traversal);
  for (const auto& [name, svg] : plots) write(std::filesystem::path(folder) / name, svg);
  write(std::filesystem::path(folder) / "traversal.md", markdown(traversal, plots, ""));
  write(std::filesystem::path(folder) / "traversal.json", json(traversal));
}

RayKind kind_from_name(const std::string& name) {
  for (const RayKind kind : all_ray_kinds)
    if (ray_kind_name(kind) == name) return kind;
  throw UsageError(fmt::format("unknown kind of rays \"{}\"; there are primary, shadow, diffuse", name));
}

void run(const TraversalCommand& options) {
  TraversalOptions what = options.what;
  if (!options.kinds.empty()) what.kinds.clear();
  for (const std::string& name : options.kinds) what.kinds.push_back(kind_from_name(name));
  for (const std::string& name : options.tiers) what.tiers.push_back(precision_from_name(name));
  const Device device = Device::open(options.device);
  const Traversal traversal =
      measure_traversal(device, what, [](const std::string& line) { fmt::print(stderr, "strahl-bench: {}\n", line); });
  fmt::print("{}", markdown(traversal, {}, ""));
  if (!options.json.empty()) write(options.json, json(traversal));
  if (!options.report.empty()) write_report(traversal, options.report);
}

}  // namespace

Command add_traversal(CLI::App& app) {
  const auto options = std::make_shared<TraversalCommand>();
  TraversalOptions& what = options->what;
  app.add_option("-d,--device", options->device, "As in strahl -d; default: the fastest GPU, else CPU");
  app.add_option("--scenes", what.scenes,
                 fmt::format("Comma-separated; files, or {}", fmt::join(generated_scene_forms(), ", ")))
      ->delimiter(',')
      ->capture_default_str()
      ->type_name("LIST");
  app.add_option("--rays", options->kinds, "Only these of primary, shadow, diffuse")->delimiter(',')->type_name("LIST");
  app.add_option("--precision", options->tiers, "Only these tiers; the first has to be right")
      ->delimiter(',')
      ->type_name("LIST");
  app.add_option("--bvh-width", what.widths, "With each of these; default: the device's")
      ->delimiter(',')
      ->type_name("LIST");
  app.add_flag("!--no-peers", what.peers, "strahl alone");
  app.add_option("--pixels", what.pixels, "The picture's side; as many rays squared")
      ->capture_default_str()
      ->check(CLI::Range(16, 8192));
  app.add_option("--rounds", what.rounds, "Timed rounds")->capture_default_str()->check(CLI::Range(1, 1000));
  app.add_option("--threads", what.threads, "Of the peers; default: as many as the machine has")
      ->check(CLI::Range(1, 1024));
  app.add_option("--json", options->json, "Every round's seconds, for programs")->type_name("FILE");
  app.add_option("--report", options->report, "Tables, plots and JSON there")->type_name("FOLDER");
  return [options] { run(*options); };
}

Command add_report(CLI::App& app) {
  const auto json_files = std::make_shared<std::vector<std::string>>();
  const auto folder = std::make_shared<std::string>();
  app.add_option("JSON", *json_files, "What traversal --json wrote; of one device")->required();
  app.add_option("-o,--output", *folder, "Tables and plots there")->required()->type_name("FOLDER");
  return [json_files, folder] { write_report(traversal_of_files(*json_files), *folder); };
}

}  // namespace strahl::bench
