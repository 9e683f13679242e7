// SPDX-License-Identifier: MIT
// `strahl render`: a scene or a mesh to a picture.
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/canary.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/interrupt.h"
#include "cli/kernel_options.h"
#include "cli/output_file.h"
#include "cli/picture_files.h"
#include "cli/progress_bar.h"
#include "cli/scene_options.h"
#include "cli/scene_overrides.h"
#include "cli/summary.h"
#include "render/limitations.h"
#include "render/renderer.h"

namespace strahl::cli {
namespace {

constexpr const char* kFooter = R"(
Examples:
  strahl render scene.xml                            writes scene.png here
  strahl render scene.xml -o out.exr --spp 256 --aov depth,normal
  strahl render scene.xml --width 320 -D colour=0.2 -d gpu
  strahl render scene.xml --pixel 100,50             prints linear R G B
  strahl render scene.xml -o out.png --stats -       where the time went, as JSON

Ctrl-C finishes the launch under way and writes the picture so far; a second one ends at once.
docs/cli.md describes every option.)";

struct RenderOptions {
  SceneOptions scene;
  SceneOverrides overrides;
  KernelOptions kernel;
  std::string device;
  std::string output;
  PngOptions png;
  std::string stats;
  bool stats_detail = false;
  std::string dump_kernel;
};

std::map<std::string, std::string> metadata_of(const RenderOptions& options, const Invocation& invocation,
                                               const RenderResult& result) {
  std::map<std::string, std::string> metadata{
      {"Software", "strahl " STRAHL_VERSION},
      {"command", invocation.command_line},
      {"scene", options.scene.path},
      {"device", result.stats.device},
      {"precision", result.stats.precision},
      {"spp", std::to_string(result.stats.spp)},
      {"seed", std::to_string(result.stats.seed)},
  };
  if (!result.stats.disabled.empty()) metadata["disabled"] = fmt::format("{}", fmt::join(result.stats.disabled, ", "));
  if (!result.complete) metadata["incomplete"] = "interrupted";
  return metadata;
}

/// What costs nothing to find out before the scene is loaded.
void require_writable_outputs(const RenderOptions& options) {
  if (!options.output.empty()) static_cast<void>(image_format(options.output));
  for (const std::string& path : {options.stats, options.dump_kernel})
    if (!path.empty() && path != "-") require_writable(path);
}

void print_pixel(const Image& color) {
  const auto channel = [&color](int c) { return color.at(0, 0, c); };
  print(fmt::format("{} {} {}\n", channel(0), channel(1), channel(2)));
}

/// Renders again with the instrumented program and takes only its counts, so that counting costs the timed one nothing.
nlohmann::ordered_json count(const Device& device, const Scene& scene, RenderSettings settings, const RenderOptions& o,
                             const InterruptGuard& guard, RunStats& stats) {
  settings.count_rays = true;
  Renderer renderer(device, scene, settings);
  ProgressBar bar("count", !o.scene.quiet && !o.scene.no_progress);
  const RenderResult counted = renderer.render([&](const Progress& progress) {
    bar.show(progress);
    return !guard.interrupted();
  });
  if (!counted.complete) return nullptr;
  stats.shadow_rays = counted.stats.shadow_rays;
  stats.bounce_rays = counted.stats.bounce_rays;
  stats.nodes_visited = counted.stats.nodes_visited;
  stats.primitives_tested = counted.stats.primitives_tested;
  return {{"program", counted.stats.program}, {"kernel", counted.stats.seconds.kernel}};
}

/// A picture that is not what the scene says: said even with -q.
void warn_of_samples(const RunStats& stats) {
  if (stats.saturated_samples > 0)
    say(fmt::format("strahl: warning: {} sample channels were brighter than the film holds; its largest value counts",
                    stats.saturated_samples));
  if (stats.invalid_samples > 0)
    say(fmt::format("strahl: warning: {} sample channels were not a number; they count as black",
                    stats.invalid_samples));
}

void say_summary(const RenderOptions& options, const std::string& picture, const RenderResult& result) {
  if (options.scene.verbose) say(kernel_summary(result.stats));
  if (options.scene.quiet) return;
  const RunStats& stats = result.stats;
  const double samples = static_cast<double>(result.color.width) * result.color.height * stats.spp;
  const std::string interrupted = result.complete ? ""
                                                  : fmt::format(" · interrupted after {:.0f} % of the samples",
                                                                100 * static_cast<double>(stats.camera_rays) / samples);
  say(fmt::format("{} · {}{}×{} · {} spp · {}{}", time_summary(stats.seconds), picture.empty() ? "" : picture + " ",
                  result.color.width, result.color.height, stats.spp, stats.device, interrupted));
}

ExitCode render(const RenderOptions& options, const Invocation& invocation) {
  RenderSettings settings = settings_of(options.kernel);
  require_writable_outputs(options);
  double load_seconds = 0;
  Scene scene = load(options.scene, load_seconds);
  apply(options.overrides, scene);
  for (const Diagnostic& warning : limitations(scene)) say(warning.text());

  PictureFiles files{options.output, options.png, scene.integrator.name == "depth"};
  const bool only_values = options.overrides.pixel && options.output.empty();
  if (!only_values) {
    if (files.path.empty()) files.path = scene.name + ".png";
    require_writable(files);
  }

  const Device device = Device::open(
      options.device, {settings.precision == Precision::fp64 || settings.aovs.contains(Aov::numeric_error)});
  const Canary canary = ask_canary(device, options.kernel, settings);
  // A large scene should not be there twice where nothing is counted.
  const Scene counted = options.stats_detail ? scene : Scene{};
  Renderer renderer(device, std::move(scene), settings);
  if (!options.dump_kernel.empty()) write_text(options.dump_kernel, renderer.program_text());

  const InterruptGuard guard;
  RenderResult result;
  {
    ProgressBar bar("render", !options.scene.quiet && !options.scene.no_progress);
    result = renderer.render([&](const Progress& progress) {
      bar.show(progress);
      return !guard.interrupted();
    });
  }
  canary.note_in(result.stats);
  result.stats.seconds.load = load_seconds;
  const double encode_start = invocation.seconds();
  if (!only_values) write(files, result, metadata_of(options, invocation, result), options.scene.quiet);
  if (options.overrides.pixel) print_pixel(result.color);
  result.stats.seconds.encode = invocation.seconds() - encode_start;
  result.stats.seconds.total = invocation.seconds();
  warn_of_samples(result.stats);
  say_summary(options, files.path, result);

  if (!options.stats.empty()) {
    nlohmann::ordered_json detail;
    if (options.stats_detail && result.complete)
      detail = count(device, counted, settings, options, guard, result.stats);
    auto json = nlohmann::ordered_json::parse(result.stats.json());
    if (options.stats_detail) json["detail"] = detail;
    write_text(options.stats, json.dump(2) + "\n");
  }
  return guard.exit_code();
}

void add_output_options(CLI::App& app, RenderOptions& options) {
  const std::string group = "Output";
  app.add_option("-o,--output", options.output, "Picture: .png, .exr or .pfm; default: the scene's name with .png")
      ->type_name("FILE")
      ->group(group);
  app.add_option("--exposure", options.png.exposure, "PNG: brighter by so many stops")
      ->type_name("STOPS")
      ->check(CLI::Range(-64.0, 64.0).description(""))
      ->group(group);
  app.add_option("--png-bits", options.png.bits, "PNG: 8 or 16 bits a channel")
      ->type_name("N")
      ->check(CLI::IsMember({8, 16}))
      ->capture_default_str()
      ->group(group);
  CLI::Option* stats = app.add_option("--stats", options.stats, "Time, rays and memory as JSON; - for standard output")
                           ->type_name("FILE")
                           ->group(group);
  app.add_flag("--stats-detail", options.stats_detail, "Renders a second time with a program that counts, for --stats")
      ->needs(stats)
      ->group(group);
  app.add_option("--dump-kernel", options.dump_kernel,
                 "The exact OpenCL program with its options; - for standard output")
      ->type_name("FILE")
      ->group(group);
}

}  // namespace

Command add_render(CLI::App& app, const Invocation& invocation) {
  const auto options = std::make_shared<RenderOptions>();
  add_scene_options(app, options->scene);
  add_device_option(app, options->device);
  add_output_options(app, *options);
  add_scene_overrides(app, options->overrides);
  add_kernel_options(app, options->kernel);
  add_canary_option(app, options->kernel);
  add_program_options(app, options->kernel);
  add_launch_options(app, options->kernel);
  app.footer(kFooter);
  return [options, &invocation] { return render(*options, invocation); };
}

}  // namespace strahl::cli
