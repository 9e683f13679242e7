// SPDX-License-Identifier: MIT
// Options that say how a scene is computed. None but --precision and --disable changes a picture.
#include "cli/kernel_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <limits>

#include "cli/number_options.h"
#include "errors.h"
#include "program/disabled.h"
#include "settings/require_settings.h"

namespace strahl::cli {
namespace {

constexpr const char* how_computed = "How it is computed";

WorkGroup work_group_of(const std::string& text) {
  const char* const end = text.data() + text.size();
  WorkGroup group{0, 1};
  auto result = std::from_chars(text.data(), end, group.x);
  if (result.ec == std::errc() && result.ptr != end && *result.ptr == 'x')
    result = std::from_chars(result.ptr + 1, end, group.y);
  if (result.ec != std::errc() || result.ptr != end || group.x < 1 || group.y < 1)
    throw UsageError(fmt::format("--work-group takes X or XxY work-items (8x8, 64), not \"{}\"", text));
  return group;
}

}  // namespace

void add_kernel_options(CLI::App& app, KernelOptions& options) {
  app.add_option("--precision", options.precision,
                 "fast: textbook formulas, for contrast; stable: single precision, formulas in stable form; robust: "
                 "single precision, exact or compensated; double")
      ->type_name("NAME")
      ->check(CLI::IsMember({"fast", "stable", "robust", "double"}))
      ->default_str("robust")
      ->group(how_computed);
  require_whole(
      app.add_option("--lanes", options.lanes,
                     "Primitives tested at a time: 1, 8 or 16 (double: 1 or 8); default: what fits the device; the "
                     "results do not change"))
      ->type_name("N")
      ->check(CLI::IsMember({1, 8, 16}))
      ->group(how_computed);
  require_whole(
      app.add_option(
          "--bvh-width", options.bvh_width,
          "Children of a tree's node: 16 or 8, tested at a time together with as many primitives, or 4 or 2, one "
          "after the other (double: up to 8); default: what fits the device; the results do not change"))
      ->type_name("N")
      ->check(CLI::IsMember({2, 4, 8, 16}))
      ->group(how_computed);
  app.add_option("--accel", options.acceleration,
                 "auto: a tree where there are enough primitives; list: every ray meets every primitive; tree; the "
                 "results do not change")
      ->type_name("NAME")
      ->check(CLI::IsMember({"auto", "list", "tree"}))
      ->default_str("auto")
      ->group(how_computed);
  app.add_option("--disable", options.disabled,
                 "Without this effect, as `strahl explain` names it, though the scene calls for it; repeatable")
      ->type_name("NAME")
      ->allow_extra_args(false)
      ->group(how_computed);
}

void add_canary_option(CLI::App& app, KernelOptions& options) {
  app.add_flag("--no-canary", options.no_canary,
               "Trust the device's arithmetic without asking it; otherwise a precision that it cannot keep is refused")
      ->group(how_computed);
}

void add_program_options(CLI::App& app, KernelOptions& options) {
  app.add_option("--aov", options.aovs,
                 "Further pictures of each pixel's first sample: depth, normal, geo_normal, position, uv, albedo, "
                 "shape_id, primitive_id, numeric_error (of t, against double, in ulps of float)")
      ->type_name("LIST")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->group("Output");
  app.add_flag("--generic", options.generic, "Every effect in the program, used or not; the picture does not change")
      ->group(how_computed);
  app.add_flag(
         "--texture-lod", options.texture_lod,
         "Filter images to the pixel's width (mip levels), where they are colours of surfaces: less noise far off, "
         "and a blur that the error does not tell")
      ->group(how_computed);
  app.add_option(
         "--light-choice", options.light_choice,
         "How a point chooses one of several lights: uniform, power, each (by power, distance and direction), or "
         "tree (so too, but by groups); default: each for few, tree for many; only the noise changes")
      ->type_name("NAME")
      ->check(CLI::IsMember({"uniform", "power", "each", "tree"}))
      ->group(how_computed);
  app.add_flag("--no-error", options.no_error,
               "Keep one sum a pixel instead of four and tell no error; sobol's samples are one sequence then, spread "
               "more evenly")
      ->group(how_computed);
}

void add_launch_options(CLI::App& app, KernelOptions& options) {
  app.add_option(
         "--paths", options.paths,
         "Samples followed at a time: one, or as many as --lanes (lanes); default: by the scene; the picture does "
         "not change")
      ->type_name("NAME")
      ->check(CLI::IsMember({"one", "lanes"}))
      ->group(how_computed);
  app.add_option("--work-group", options.work_group, "Work-items per group; the picture does not change")
      ->type_name("XxY")
      ->group(how_computed);
  app.add_option("--memory-limit", options.memory_limit,
                 "The most that scene and film may take on the device, as 512M or 2G; a film that does not fit is "
                 "rendered in bands, a scene that does not is refused; the picture does not change")
      ->type_name("BYTES")
      ->group(how_computed);
  require_whole(
      app.add_option("--passes", options.passes,
                     "Split the samples into N passes; default: by measured time; the picture does not change"))
      ->type_name("N")
      ->check(CLI::Range(1, std::numeric_limits<int>::max()).description(""))
      ->group(how_computed);
}

std::optional<std::uint64_t> memory_limit(const KernelOptions& options) {
  if (!options.memory_limit) return std::nullopt;
  const std::string& text = *options.memory_limit;
  const char* const end = text.data() + text.size();
  std::uint64_t number = 0;
  const auto [at, error] = std::from_chars(text.data(), end, number);
  std::string unit(at, end);
  if (unit.size() == 3 && unit.ends_with("iB")) unit.resize(1);
  const int shift = unit.empty() ? 0 : unit == "k" || unit == "K" ? 10 : unit == "M" ? 20 : unit == "G" ? 30 : -1;
  if (error != std::errc() || shift < 0 || number == 0 || number > UINT64_MAX >> shift)
    throw UsageError(fmt::format("--memory-limit takes bytes, as 512M, 512MiB or 2G, not \"{}\"", text));
  return number << shift;
}

RenderSettings settings_of(const KernelOptions& options) {
  RenderSettings settings;
  settings.precision = precision_from_name(options.precision.value_or("robust"));
  settings.lanes = options.lanes;
  if (options.lanes && !is_lane_count(*options.lanes, settings.precision))
    throw UsageError("--precision double has 1 or 8 lanes, not 16");
  settings.bvh_width = options.bvh_width;
  if (options.bvh_width && !is_tree_width(*options.bvh_width, settings.precision))
    throw UsageError("--precision double has trees of width 2, 4 or 8, not 16");
  if (options.lanes && options.bvh_width && lanes_of_tree(*options.bvh_width) != *options.lanes)
    throw UsageError(fmt::format("--bvh-width {} tests {} at a time, not --lanes {}: state one of them",
                                 *options.bvh_width, lanes_of_tree(*options.bvh_width), *options.lanes));
  if (options.paths) settings.paths_in_lanes = *options.paths == "lanes";
  if (options.acceleration == "list") settings.acceleration = Acceleration::list;
  if (options.acceleration == "tree") settings.acceleration = Acceleration::tree;
  if (!options.work_group.empty()) settings.work_group = work_group_of(options.work_group);
  settings.passes = options.passes;
  settings.generic = options.generic;
  settings.estimate_error = !options.no_error;
  settings.texture_lod = options.texture_lod;
  settings.light_choice = options.light_choice;
  settings.disabled.insert(options.disabled.begin(), options.disabled.end());
  static_cast<void>(disabled_effects(settings.disabled));  // Says what is wrong with it before a scene is loaded.
  for (const std::string& name : options.aovs) settings.aovs.add(first_sample_aov(name));
  return settings;
}

}  // namespace strahl::cli
