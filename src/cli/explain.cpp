// SPDX-License-Identifier: MIT
// `strahl explain`: which effects a scene calls for, where, and which program that makes.
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/kernel_options.h"
#include "cli/scene_options.h"
#include "cli/scene_overrides.h"
#include "device/device.h"
#include "device/features.h"
#include "device/program_text.h"
#include "device/tuned_width.h"

namespace strahl::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFooter = R"(
Lists every effect, on or off, with the scene element that called for it, and the hash of the rendering program. The
program depends on the number of lanes: that of --lanes, else what fits the device, else (no device at all) 1.

Examples:
  strahl explain scene.xml
  strahl explain scene.xml --integrator normals --aov depth
  strahl explain scene.xml --json --lanes 8)";

struct ExplainOptions {
  SceneOptions scene;
  SceneOverrides overrides;
  KernelOptions kernel;
  std::string device;
  bool json = false;
};

struct Lanes {
  int count = 1;
  int tree = 4;
  std::string why;
};

Lanes lanes_for(const ExplainOptions& options, const RenderSettings& settings) {
  if (settings.lanes || settings.bvh_width) {
    const Width width = width_of(settings, 1);
    return {width.lanes, width.tree, settings.lanes ? "--lanes" : "--bvh-width"};
  }
  try {
    const Device device = Device::open(options.device, {settings.precision == Precision::fp64});
    const Width width = width_on(device, settings);
    return {width.lanes, width.tree, "for " + device.info().text()};
  } catch (const NoDeviceError&) {
    if (!options.device.empty()) throw;  // It was asked for by name.
    return {1, 4, "no OpenCL device; --lanes states another number"};
  }
}

std::string text_of(const Features& features, const std::string& program, const RenderSettings& settings,
                    const Lanes& lanes) {
  std::size_t name_width = 0;
  std::size_t why_width = 0;
  for (const FeatureReport& feature : features.report) {
    name_width = std::max(name_width, feature.name.size());
    why_width = std::max(why_width, feature.why.size());
  }
  std::string text = fmt::format("program {} · {} · {} lane{} ({})\n", program, precision_name(settings.precision),
                                 lanes.count, lanes.count == 1 ? "" : "s", lanes.why);
  for (const FeatureReport& feature : features.report) {
    std::string line = fmt::format("{:<3}  {:<{}}  {:<{}}  {}", feature.on ? "on" : "off", feature.name, name_width,
                                   feature.why, why_width, feature.where.text());
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

std::string json_of(const Features& features, const std::string& program, const RenderSettings& settings,
                    const Lanes& lanes) {
  Json list = Json::array();
  for (const FeatureReport& feature : features.report) {
    const std::string where = feature.where.text();
    list.push_back({{"name", feature.name},
                    {"on", feature.on},
                    {"why", feature.why},
                    {"where", where.empty() ? Json(nullptr) : Json(where)}});
  }
  const Json json = {{"program", program},
                     {"features", list},
                     {"precision", precision_name(settings.precision)},
                     {"lanes", lanes.count}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

ExitCode explain(const ExplainOptions& options) {
  const RenderSettings settings = settings_of(options.kernel);
  double load_seconds = 0;
  Scene scene = load(options.scene, load_seconds);
  apply(options.overrides, scene);
  const Features features = features_of(scene, settings);
  const Lanes lanes = lanes_for(options, settings);
  const std::string program =
      program_hash(program_source("kernels/render.cl", features, settings.precision, lanes.count, lanes.tree));
  print((options.json ? json_of : text_of)(features, program, settings, lanes));
  return ExitCode::ok;
}

}  // namespace

Command add_explain(CLI::App& app) {
  const auto options = std::make_shared<ExplainOptions>();
  add_scene_options(app, options->scene);
  add_device_option(app, options->device);
  app.add_flag("--json", options->json, "For programs");
  add_scene_overrides(app, options->overrides);
  add_kernel_options(app, options->kernel);
  add_program_options(app, options->kernel);
  app.footer(kFooter);
  return [options] { return explain(*options); };
}

}  // namespace strahl::cli
