// SPDX-License-Identifier: MIT
// Options around the scene file, and loading it.
#include "cli/scene_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>

#include "cli/console.h"
#include "cli/progress_bar.h"
#include "scene/loader.h"

namespace strahl::cli {

void add_scene_options(CLI::App& app, SceneOptions& options) {
  app.add_option("scene", options.path, "Mitsuba XML scene, or an .obj, .ply or .serialized mesh")
      ->required()
      ->type_name("SCENE");
  app.add_option("-D", options.defines, "Define $NAME of the scene; overrides its <default>; repeatable")
      ->type_name("NAME=VALUE")
      ->allow_extra_args(false);
  app.add_option("--sensor", options.sensor,
                 "The camera of a scene that has several: the id of a <sensor>, or its number from 0 on")
      ->type_name("ID|N");
  app.add_flag("--strict", options.strict, "Unknown plugins and parameters of the scene are errors");
  app.add_option(
         "--root", options.root,
         "Read none of the scene's files but those below this folder, links resolved: for other people's scenes")
      ->type_name("DIR");
  CLI::Option* quiet = app.add_flag("-q", options.quiet, "Say nothing but warnings and errors");
  app.add_flag("-v", options.verbose, "Say more: device, program, cache, launches (render, intersect)")
      ->excludes(quiet);
  app.add_flag("--no-progress", options.no_progress, "No progress bar");
}

void add_device_option(CLI::App& app, std::string& selector, const std::string& more) {
  app.add_option("-d,--device", selector,
                 "Index (0, 0:1), kind (cpu, gpu) or part of the platform's or device's name (pocl, intel); default: "
                 "the fastest GPU, else CPU" +
                     more)
      ->type_name("DEVICE");
}

void say_diagnostics(const std::vector<Diagnostic>& diagnostics, bool with_notes) {
  for (const Diagnostic& one : diagnostics)
    if (with_notes || one.severity != Severity::note) say(one.text());
}

Scene load(const SceneOptions& options, double& seconds) {
  LoadOptions load_options;
  load_options.strict = options.strict;
  load_options.root = options.root;
  load_options.sensor = options.sensor;
  for (const std::string& define : options.defines) {
    const std::size_t equals = define.find('=');
    if (equals == std::string::npos || equals == 0)
      throw UsageError(fmt::format("-D takes name=value, not \"{}\"", define));
    load_options.defines[define.substr(0, equals)] = define.substr(equals + 1);
  }
  const auto start = std::chrono::steady_clock::now();
  LoadedScene loaded = [&] {
    ProgressBar bar("load", !options.quiet && !options.no_progress);
    load_options.progress = [&bar](const std::string& file, double share) {
      bar.show(share, std::filesystem::path(file).filename().string());
    };
    return load_scene(options.path, load_options);
  }();
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  say_diagnostics(loaded.warnings, options.verbose);
  return std::move(loaded.scene);
}

}  // namespace strahl::cli
