// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "bench/commands.h"
#include "bench/effect_rows.h"
#include "bench/effects.h"
#include "image/atomic_file.h"
#include "image/file_bytes.h"

namespace strahl::bench {
namespace {

constexpr const char* scenes_folder = STRAHL_BENCH_FOLDER "/../scenes/";
constexpr const char *begin_mark = "<!-- measured: bench/run effects -->\n",
                     *each_mark = "<!-- measured: bench/run effects --each -->\n", *end_mark = "<!-- end -->";

struct EffectsCommand {
  EffectsOptions what;
  std::string device;
  bool each = false;
  std::string report;
};

void write(const std::string& path, const std::string& text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

/// Between the marks; the JSON goes beside, under its own name.
void write_report(const std::string& path, const char* mark, const std::string& measured, const std::string& json_path,
                  const std::string& json_text) {
  std::string page = read_file(path);
  const std::size_t begin = page.find(mark), end = page.find(end_mark, begin);
  if (begin == std::string::npos || end == std::string::npos)
    throw UsageError(fmt::format("{}: there are no marks `{}` and `{}` around what is measured", path,
                                 std::string(mark).substr(0, std::string(mark).size() - 1), end_mark));
  const std::size_t from = begin + std::string(mark).size();
  page.replace(from, end - from, measured);
  write(path, page);
  write(json_path, json_text);
}

void run(EffectsCommand options) {
  keep_drivers_from_caching();
  options.what.folder = scenes_folder;
  if (options.what.scenes.empty())
    for (const auto& entry : std::filesystem::recursive_directory_iterator(scenes_folder))
      if (entry.path().extension() == ".xml" && entry.path().stem() != "stage")
        options.what.scenes.push_back(entry.path().string());
  std::sort(options.what.scenes.begin(), options.what.scenes.end());
  const Device device = Device::open(options.device);
  const EffectsProgress tell = [](const std::string& line) { fmt::print(stderr, "strahl-bench: {}\n", line); };
  const std::string stem = std::filesystem::path(options.report).replace_extension().string();
  if (options.each) {
    const std::vector<EffectRow> rows = measure_effect_rows(device, options.what, tell);
    fmt::print("{}", markdown(rows, device));
    if (!options.report.empty())
      write_report(options.report, each_mark, markdown(rows, device), stem + "-each.json", json(rows, device));
    return;
  }
  const Effects effects = measure_effects(device, options.what, tell);
  fmt::print("{}", markdown(effects));
  if (!options.report.empty())
    write_report(options.report, begin_mark, markdown(effects), stem + ".json", json(effects));
}

}  // namespace

Command add_effects(CLI::App& app) {
  const auto options = std::make_shared<EffectsCommand>();
  app.add_option("-d,--device", options->device, "As in strahl -d; default: the fastest GPU, else CPU");
  app.add_option("--scenes", options->what.scenes, "Comma-separated files; default: all that are shipped")
      ->delimiter(',')
      ->type_name("LIST");
  CLI::Option* spheres = app.add_flag("--spheres", options->what.only_spheres, "The ten spheres alone");
  app.add_flag("--each", options->each, "A row for each effect instead: with it and without it")->excludes(spheres);
  app.add_option("--rounds", options->what.rounds, "Timed rounds")->capture_default_str()->check(CLI::Range(1, 1000));
  app.add_option("--frame", options->what.frame_seconds, "Seconds that a timed frame takes, about")
      ->capture_default_str()
      ->check(CLI::Range(0.001, 60.0));
  app.add_option("--report", options->report,
                 "A page with marks around what is measured (docs/effects.md); JSON beside")
      ->excludes(spheres)
      ->type_name("FILE");
  return [options] { run(*options); };
}

}  // namespace strahl::bench
