// SPDX-License-Identifier: MIT
// `strahl intersect`: rays in, hits out, through the same kernels as a render.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "cli/canary.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/distinct_files.h"
#include "cli/kernel_options.h"
#include "cli/number_options.h"
#include "cli/output_file.h"
#include "cli/process_clock.h"
#include "cli/ray_matrix.h"
#include "cli/scene_options.h"
#include "cli/summary.h"

namespace strahl::cli {
namespace {

constexpr const char* intersect_footer = R"(
Rays: N x 8 float32 or float64 (origin x y z, direction x y z of any length, t_min, t_max; t_min <= t <= t_max counts),
or N x 11 (and the instance, shape and primitive just left, -1: none).
Hits: N x 9 float64 (t, instance, shape, primitive, u, v, unit normal x y z); a miss is inf -1 -1 -1 0 0 0 0 0.

Examples:
  strahl intersect scene.xml --rays rays.npy -o hits.npy
  strahl intersect mesh.ply --rays rays.npy -o hits.npy --precision double
  strahl intersect scene.xml --rays rays.npy -o hits.npy --repeat 9 --stats -

docs/cli.md has the meaning of primitive, u and v for each shape.)";

struct IntersectOptions {
  SceneOptions scene;
  KernelOptions kernel;
  std::string device;
  std::string rays;
  std::string output;
  bool any_hit = false;
  bool coherent = false;
  int repeat = 1;
  std::string stats;
};

/// A picture's name would promise a picture. What is no regular file has no ending to go by: a pipe, /dev/null.
void require_npy(const std::string& path) {
  std::error_code unknown;
  const std::filesystem::file_status status = std::filesystem::status(path, unknown);
  const bool is_stream = std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
  if (is_stream || std::filesystem::path(path).extension() == ".npy") return;
  throw UsageError(fmt::format("-o {}: hits are a NumPy matrix; name a file that ends in .npy", path));
}

ExitCode intersect(const IntersectOptions& options, const Invocation& invocation) {
  RenderSettings settings = settings_of(options.kernel);
  settings.coherent = options.coherent;
  require_npy(options.output);
  std::vector<NamedFile> inputs = scene_files(options.scene.path, {});
  inputs.push_back({"--rays", options.rays});
  const std::vector<NamedFile> outputs{{"-o", options.output}, {"--stats", options.stats}};
  require_distinct(outputs, inputs);
  require_writable(options.output);
  if (!options.stats.empty() && options.stats != "-") require_writable(options.stats);

  double load_seconds = 0;
  const Scene scene = load(options.scene, load_seconds);
  require_distinct(outputs, scene_files(options.scene.path, scene.files));
  const double rays_start = invocation.seconds();
  const std::vector<Ray> rays = rays_of(read_npy(options.rays), options.rays);
  load_seconds += invocation.seconds() - rays_start;

  const double opening = invocation.seconds();
  const Device device = Device::open(options.device, {settings.precision == Precision::fp64});
  const double device_seconds = invocation.seconds() - opening;
  const Canary canary = ask_canary(device, options.kernel, settings);
  Intersector intersector(device, scene, settings);
  const std::vector<Hit> hits = intersector.trace(rays, options.any_hit, options.repeat);

  RunStats stats = intersector.stats();
  const double encode_start = invocation.seconds();
  write_npy(matrix_of(hits), options.output);
  canary.note_in(stats);
  stats.seconds.start = invocation.main_seconds;
  stats.seconds.device = device_seconds;
  stats.seconds.load = load_seconds;
  stats.seconds.encode = invocation.seconds() - encode_start;
  stats.seconds.exit = expected_exit_seconds({device});
  stats.seconds.total = invocation.seconds() + stats.seconds.exit;

  if (options.scene.verbose) say(kernel_summary(stats));
  if (!options.scene.quiet) {
    const auto is_hit = [](const Hit& hit) { return hit.t < std::numeric_limits<double>::infinity(); };
    const auto count = std::count_if(hits.begin(), hits.end(), is_hit);
    say(fmt::format("{} · {} {} of {} rays hit · {:.2f} Mrays/s · {}", time_summary(stats.seconds), options.output,
                    count, rays.size(),
                    stats.seconds.kernel > 0 ? static_cast<double>(rays.size()) / stats.seconds.kernel / 1e6 : 0.0,
                    stats.device));
  }
  if (!options.stats.empty()) write_text(options.stats, stats.json());
  return ExitCode::ok;
}

}  // namespace

Command add_intersect(CLI::App& app, const Invocation& invocation) {
  const auto options = std::make_shared<IntersectOptions>();
  add_scene_options(app, options->scene);
  add_device_option(app, options->device);
  app.add_option("--rays", options->rays, "The rays")->required()->type_name("R.npy");
  app.add_option("-o,--output", options->output, "The hits")->required()->type_name("H.npy");
  app.add_flag("--any-hit", options->any_hit, "Only whether something is hit: t is 0 then, ids stay -1");
  app.add_flag("--coherent", options->coherent,
               "A hint that neighbouring rays are alike; the hits do not depend on it");
  require_whole(app.add_option("--repeat", options->repeat, "Trace N times; seconds.kernel of --stats is the median"))
      ->type_name("N")
      ->check(CLI::Range(1, 1000000).description(""));
  app.add_option("--stats", options->stats, "Time and memory as JSON; - for standard output")->type_name("FILE");
  add_kernel_options(app, options->kernel);
  add_canary_option(app, options->kernel);
  app.footer(intersect_footer);
  return [options, &invocation] { return intersect(*options, invocation); };
}

}  // namespace strahl::cli
