// SPDX-License-Identifier: MIT
// `strahl stress`: one scene in other units and elsewhere, in every tier, as a contact sheet and a table.
#include "study/stress.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/distinct_files.h"
#include "cli/number_options.h"
#include "cli/output_file.h"
#include "cli/picture_files.h"
#include "cli/progress_bar.h"
#include "cli/scene_options.h"
#include "cli/scene_overrides.h"
#include "json_text.h"
#include "render/limitations.h"
#include "settings/sampling.h"

namespace strahl::cli {
namespace {

constexpr const char* stress_footer = R"(
Renders the scene at scales of 1e-6 to 1e6, at offsets of up to 1e7 along each axis, by 1e-10 and 1e10 times the light,
and with one more lamp that is far (1e7 times the scene's extent) or small (1e-7 of its distance), in every precision
that the device has, and prints how far each picture is from the scene as it is in double, and each with a lamp from
the one with the same lamp in double. With exact numbers all distances would be 0.

Examples:
  strahl stress scene.xml                            writes scene.stress.png here
  strahl stress scene.xml -o sheet.png --width 160 --spp 16
  strahl stress scene.xml -d gpu --json stress.json

No canary is asked: what a device does to a precision that it cannot keep is seen here.)";

struct StressOptions {
  SceneOptions scene;
  std::string device;
  std::string output;
  std::string json;
  int width = 96;
  int spp = 4;
};

std::string table(const StressStudy& study) {
  std::string text = fmt::format("RMSE against {}, as it is; of far and lamp with the same lamp\n{:<8}",
                                 precision_name(study.reference), "");
  for (const Stress& stress : all_stresses()) text += fmt::format(" {:>13}", stress.text());
  for (std::size_t i = 0; i < study.tiers.size(); ++i) {
    text += fmt::format("\n{:<8}", precision_name(study.tiers[i]));
    for (const StressCell& cell : study.cells[i]) text += fmt::format(" {:>13.3g}", cell.rmse);
  }
  return text + "\n";
}

std::string json_of(const StressStudy& study, const Scene& scene, const Device& device) {
  nlohmann::ordered_json stresses = nlohmann::ordered_json::array(), tiers = nlohmann::ordered_json::array();
  for (const Stress& stress : all_stresses())
    stresses.push_back({{"scale", stress.scale},
                        {"offset", stress.offset},
                        {"light", stress.light},
                        {"far", stress.far},
                        {"lamp", stress.lamp}});
  for (std::size_t i = 0; i < study.tiers.size(); ++i) {
    nlohmann::ordered_json errors = nlohmann::ordered_json::array();
    for (const StressCell& cell : study.cells[i]) errors.push_back(cell.rmse);
    tiers.push_back({{"precision", precision_name(study.tiers[i])}, {"rmse", errors}});
  }
  const nlohmann::ordered_json json{{"scene", scene.name},
                                    {"device", device.info().text()},
                                    {"reference", precision_name(study.reference)},
                                    {"stresses", stresses},
                                    {"tiers", tiers}};
  return json_text(json);
}

ExitCode stress(const StressOptions& options, const Invocation& invocation) {
  require_distinct({{"-o", options.output}, {"--json", options.json}}, scene_files(options.scene.path, {}));
  if (!options.json.empty() && options.json != "-") require_writable(options.json);
  double load_seconds = 0;
  Scene scene = load(options.scene, load_seconds);
  show_whole_picture(scene.film);
  SceneOverrides overrides;
  overrides.width = options.width;
  overrides.spp = options.spp;
  apply(overrides, scene);
  for (const Diagnostic& warning : limitations(scene)) say(warning.text());
  const std::string path = options.output.empty() ? scene.name + ".stress.png" : options.output;
  require_distinct({{"-o", path}, {"--json", options.json}}, scene_files(options.scene.path, scene.files));
  require_writable(PictureFiles{path, {}, false});

  const Device device = Device::open(options.device);
  const double start = invocation.seconds();
  StressStudy study;
  {
    const Window window = scene.film.window();
    const auto samples = static_cast<std::uint64_t>(window.width()) * static_cast<std::uint64_t>(window.height()) *
                         static_cast<std::uint64_t>(resolve_sampling(scene).spp);
    ProgressBar bar("stress", !options.scene.quiet && !options.scene.no_progress);
    study = study_stress(device, scene, [&](int done, int total) {
      bar.show({static_cast<std::uint64_t>(done) * samples, static_cast<std::uint64_t>(total) * samples,
                invocation.seconds() - start});
    });
  }
  Image sheet = stress_sheet(study);
  sheet.metadata = {{"Software", "strahl " STRAHL_VERSION},
                    {"command", invocation.command_line},
                    {"scene", options.scene.path},
                    {"device", device.info().text()},
                    {"reference", precision_name(study.reference)}};
  static_cast<void>(write_image(sheet, path));
  if (options.json != "-") print(table(study));
  if (!options.json.empty()) write_text(options.json, json_of(study, scene, device));
  if (!options.scene.quiet) say(fmt::format("{:.1f} s · {} · {}", invocation.seconds(), path, device.info().text()));
  return ExitCode::ok;
}

}  // namespace

Command add_stress(CLI::App& app, const Invocation& invocation) {
  const auto options = std::make_shared<StressOptions>();
  add_scene_options(app, options->scene);
  add_device_option(app, options->device);
  app.add_option("-o,--output", options->output, "The sheet; default: the scene's name with .stress.png")
      ->type_name("FILE");
  app.add_option("--json", options->json, "The table for programs; - for standard output, in its place")
      ->type_name("FILE");
  require_whole(app.add_option("--width", options->width, "Of each picture, in pixels"))
      ->type_name("N")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024).description(""));
  require_whole(app.add_option("--spp", options->spp, "Samples per pixel"))
      ->type_name("N")
      ->capture_default_str()
      ->check(CLI::Range(1, 65536).description(""));
  app.footer(stress_footer);
  return [options, &invocation] { return stress(*options, invocation); };
}

}  // namespace strahl::cli
