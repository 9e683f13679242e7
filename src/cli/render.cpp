// SPDX-License-Identifier: MIT
// `strahl render`: a scene or a mesh to a picture.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/canary.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/dry_run.h"
#include "cli/interrupt.h"
#include "cli/number_options.h"
#include "cli/output_file.h"
#include "cli/picture_keeper.h"
#include "cli/picture_metadata.h"
#include "cli/process_clock.h"
#include "cli/progress_bar.h"
#include "cli/ray_counts.h"
#include "cli/render_files.h"
#include "cli/render_frames.h"
#include "cli/render_goal.h"
#include "cli/scene_aovs.h"
#include "cli/shared_devices.h"
#include "cli/summary.h"
#include "cli/watchdog.h"
#include "image/atomic_file.h"
#include "json_text.h"
#include "kinds/integrators.h"
#include "render/limitations.h"
#include "render/renderer.h"
#include "render/rounding_pilot.h"
#include "stopwatch.h"

namespace strahl::cli {
namespace {

constexpr const char* render_footer = R"(
Examples:
  strahl render scene.xml                            writes scene.png here
  strahl render scene.xml -o out.exr --spp 256 --aov depth,normal
  strahl render scene.xml --width 320 -D colour=0.2 -d gpu
  strahl render scene.xml --pixel 100,50             prints linear R G B
  strahl render scene.xml -o out.png --stats -       where the time went, as JSON
  strahl render scene.xml --time 10s                 the best picture in ten seconds
  strahl render scene.xml --max-error 0.01           until the RMSE is 0.01
  strahl render scene.xml --max-error 0.01 --dry-run what that would take
  strahl render scene.xml -d 0,1                     a picture by two devices, each as much as it can
  strahl render scene.xml --spp 4096 --checkpoint s.ckpt     kept every minute ...
  strahl render scene.xml --spp 4096 --resume s.ckpt         ... and gone on from, bit for bit
  strahl render scene.xml --spp 4096 --samples 0:1024 --checkpoint a.ckpt   a part, for `strahl merge`

Ctrl-C finishes the launch under way and writes the picture so far; a second one ends at once.
docs/cli.md describes every option.)";

/// What costs nothing to find out before the scene is loaded.
void require_writable_outputs(const RenderOptions& options) {
  for (const std::string& path : {options.output, options.error_map})
    if (!path.empty()) static_cast<void>(image_format(path));
  require_distinct_files(options, options.output, {});
  if (!options.error_map.empty()) require_writable(options.error_map);
  for (const std::string& path : {options.stats, options.dump_kernel})
    if (!path.empty() && path != "-") require_writable(path);
  if (!options.keep.resume.empty()) static_cast<void>(read_checkpoint_header(options.keep.resume));
  if (options.keep.target().empty()) return;
  std::error_code unknown;
  // Written again and again, each in the place of the one before.
  const std::filesystem::file_status status = std::filesystem::status(options.keep.target(), unknown);
  if ((std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
       !std::filesystem::is_directory(status)) ||
      is_open_already(options.keep.target()))
    throw UsageError(
        fmt::format("a checkpoint is a file, and \"{}\" is none; choose another name", options.keep.target()));
  require_writable(options.keep.target());
}

void print_pixel(const Image& color) {
  const auto channel = [&color](int c) { return color.at(0, 0, c); };
  print(fmt::format("{} {} {}\n", channel(0), channel(1), channel(2)));
}

void say_summary(const RenderOptions& options, const std::string& picture, const RenderResult& result,
                 const Clipping& clipping) {
  if (options.scene.verbose) say(kernel_summary(result.stats));
  if (options.scene.quiet) return;
  const int bits = !picture.empty() && image_format(picture) == ImageFormat::png ? options.png.bits : 0;
  const Billed billed{picture,
                      result.color.width,
                      result.color.height,
                      result.complete,
                      options.goal.time || options.goal.max_error,
                      bits,
                      clipping};
  say(options.brief ? brief_bill(result.stats, billed) : bill(result.stats, billed));
}

/// Bytes a second that a disk takes at the least, flushed. What it falls short of makes a picture late, not wrong.
constexpr double checkpoint_rate = 1e8;

/// What the process may take to write its files and to end once its picture is done; 0 where nobody asks.
double end_seconds(const RenderOptions& options, const PictureFiles& files, const Renderer& renderer,
                   const AovList& aovs, const std::vector<Device>& devices) {
  if (!options.goal.time && !options.goal.dry_run) return 0;
  const Window window = renderer.scene().film.window();
  const double pixels = static_cast<double>(window.width()) * window.height();
  // The film, and three pictures of floats.
  double seconds = expected_exit_seconds(devices, pixels * (96 + 36));
  if (!files.path.empty()) seconds += expected_write_seconds(files.path, files.png, pixels, aovs);
  if (!options.error_map.empty()) seconds += expected_write_seconds(options.error_map, {}, pixels);
  if (!options.keep.target().empty()) {
    const double kept =
        pixels * (static_cast<double>(renderer.film_bytes_per_pixel()) + sizeof(int) +
                  (aovs.empty() ? 0.0 : layout::AOV_REALS * sizeof(double) + layout::AOV_INTS * sizeof(int)));
    seconds += 0.02 + kept / checkpoint_rate;
  }
  return seconds;
}

/// Why float rounding was not measured, though it was asked for.
std::string why_unmeasured(const RenderOptions& options, const Device& device, const RenderSettings& settings,
                           const InterruptGuard& guard) {
  if (settings.precision == Precision::fp64) return "double is what others are measured against";
  if (!device.info().fp64) return "the device has no double";
  if (options.goal.time) return "--time leaves no time for it";
  if (guard.interrupted()) return "interrupted";
  return options.scene.verbose ? "the scene is too large to be there twice" : "-v does";
}

/// A twentieth of the run at the most, unless -v asks for details: it may have to build a second program. With a
/// deadline there is no time for it.
void add_rounding(const RenderOptions& options, const Invocation& invocation, const Device& device, const Scene& scene,
                  const RenderSettings& settings, const InterruptGuard& guard, RunStats& stats) {
  if (!stats.error) return;
  stats.error->unmeasured = why_unmeasured(options, device, settings, guard);
  if (options.goal.time || guard.interrupted()) return;
  const Stopwatch start;
  std::optional<double> most;
  if (!options.scene.verbose) most = rounding_share * invocation.seconds();
  std::string fault;
  try {
    stats.error->rounding = rounding_rmse(device, scene, settings, stats, most, [&] { return !guard.interrupted(); });
  } catch (const std::exception& thrown) {  // The picture is written by now, and is what it is.
    fault = thrown.what();
    say("strahl: warning: float rounding is not measured: " + fault);
  }
  stats.error->unmeasured = fault.empty() ? why_unmeasured(options, device, settings, guard) : fault;
  stats.seconds.error += start.seconds();
}

/// The files, and what is known of them afterwards.
Clipping write_outputs(const RenderOptions& options, const PictureFiles& files, const Invocation& invocation,
                       RenderResult& result) {
  const double start = invocation.seconds();
  const std::map<std::string, std::string> metadata = metadata_of(options, invocation, result);
  Clipping clipping;
  if (!files.path.empty()) {
    const Written written = write(files, result, metadata, options.scene.quiet);
    if (result.stats.error) {
      result.stats.error->output = written.report.rounding_rmse;
      result.stats.error->clipping = written.report.clipping_rmse;
    }
    if (written.clipping) result.stats.clipped_pixels = (clipping = *written.clipping).share;
  }
  if (!options.error_map.empty()) {
    if (!result.error)
      say(fmt::format("strahl: error: --error-map \"{}\" is not written: {}", options.error_map,
                      why_no_error(result.stats)));
    else
      write_error_map(options.error_map, result.standard_error, metadata);
  }
  if (options.overrides.pixel) print_pixel(result.color);
  result.stats.seconds.encode = invocation.seconds() - start;
  return clipping;
}

/// Of snapshots too. Without a checkpoint nobody asks what it would be of.
CheckpointHeader checkpoint_header(const RenderOptions& options, const Invocation& invocation, const Device& device,
                                   const Renderer& renderer, const RenderSettings& settings, const RenderGoal& goal) {
  CheckpointHeader header;
  header.metadata = metadata_of(options, invocation, renderer.stats());
  header.aovs = settings.aovs.plain_names();
  header.named_aovs = settings.aovs.named();
  header.is_length = kinds::integrator(renderer.scene().integrator.name).is_length;
  if (goal.samples) header.first_sample = goal.samples->first;
  if (!goal.is_open()) header.spp = goal.spp.value_or(renderer.stats().spp);
  if (!options.keep.target().empty())
    header.identity = identity_of(device, renderer, settings, options.scene.defines, goal);
  return header;
}

/// What a reader that leaves early (`| head -1`) has not got; the picture is rendered all the same.
std::optional<std::string> dump_kernel(const std::string& path, const Renderer& renderer) {
  if (path.empty()) return std::nullopt;
  try {
    write_text(path, renderer.program_text());
  } catch (const Error& fault) {
    if (path != "-") throw;
    say(fmt::format("strahl: error: --dump-kernel: {}", fault.what()));
    return fault.what();
  }
  return std::nullopt;
}

ExitCode render(const RenderOptions& options, const Invocation& invocation) {
  RenderSettings settings = settings_of(options.kernel);
  settings.error_map = !options.error_map.empty();
  check_goal(options);
  static_cast<void>(memory_limit(options.kernel));
  const std::vector<std::string> selectors = device_selectors(options);
  require_writable_outputs(options);
  double load_seconds = 0;
  Scene scene = load(options.scene, load_seconds);
  apply(options.overrides, scene);
  require_map_samples(options, scene);
  for (const Diagnostic& warning : limitations(scene, settings.disabled)) say(warning.text());
  const bool is_scaled_single = settings.precision == Precision::stable || settings.precision == Precision::robust;
  if (const auto warning = too_wide_for_single(scene); warning && is_scaled_single) say(warning->text());
  if (settings.precision != Precision::fp64)
    if (const auto warning = too_dense_for_single(scene, is_scaled_single ? camera_frame(scene).origin : Vec3{}))
      say(warning->text());

  PictureFiles files{options.output, options.png, kinds::integrator(scene.integrator.name).is_length};
  if (options.writes_picture()) {
    if (files.path.empty()) files.path = scene.name + ".png";
    if (!options.goal.frames) require_writable(files);
  }
  require_distinct_files(options, files.path, scene.files);
  const bool is_png = !files.path.empty() && image_format(files.path) == ImageFormat::png;
  if (is_png && !options.scene.quiet && !options.goal.frames) files.lamps = lamps_of(scene);
  add_scene_aovs(scene, options, files.path, settings.aovs);
  warn_of_rounded_ids(scene, settings.aovs);
  if (!files.path.empty()) warn_of_later_samples(options.keep, settings.aovs);
  const bool has_first_samples = !options.keep.samples || sample_range(*options.keep.samples).first == 0;
  if (!files.path.empty() && options.goal.frames)
    require_writable_frames(files.path, *options.goal.frames, settings.aovs.plain_names());
  else if (!files.path.empty() && has_first_samples)
    require_writable_layers(files.path, settings.aovs.plain_names());

  std::optional<ProgressBar> bar;
  bar.emplace(options.goal.dry_run ? "dry run" : "render", !options.scene.quiet && !options.scene.no_progress);
  const double opening = invocation.seconds();
  const DeviceNeeds needs{settings.precision == Precision::fp64 || settings.aovs.contains(Aov::numeric_error),
                          memory_limit(options.kernel)};
  const Device device = Device::open(selectors.front(), needs);
  const double device_seconds = invocation.seconds() - opening;
  const Canary canary = ask_canary(device, options.kernel, settings);
  const ResolvedSampling sampling = resolve_sampling(scene);
  // A large scene should not be there twice where nothing is counted.
  const Scene counted = options.stats_detail ? scene : Scene{};
  Renderer::require_samples(scene, settings, goal_of(options, invocation, 0));
  std::optional<Renderer> made(std::in_place, device, std::move(scene), settings);
  Renderer& renderer = *made;
  const std::vector<SharedDevice> shared = share(renderer, device, selectors, needs, options.kernel, settings);
  const std::vector<Device> devices = devices_of(shared);
  const std::optional<std::string> not_dumped = dump_kernel(options.dump_kernel, renderer);
  const auto ended = [&not_dumped](ExitCode code) { return not_dumped ? ExitCode::failure : code; };

  const auto end = [&] { return end_seconds(options, files, renderer, settings.aovs, devices); };
  // Without a guard: a dry run has nothing to lose, so a signal ends it at once.
  if (options.goal.dry_run) return ended(dry_run(renderer, options, invocation, {canary.seconds, end(), sampling.spp}));
  const InterruptGuard guard;
  if (options.goal.frames) {
    bar.reset();
    return ended(render_frames(renderer, options, invocation, files, sampling.seed, guard));
  }
  const RenderGoal goal = goal_of(options, invocation, end());
  PictureKeeper keeper(options.keep, files, checkpoint_header(options, invocation, device, renderer, settings, goal));
  Watchdog watchdog(options.keep.watchdog ? duration_seconds(*options.keep.watchdog, "--watchdog") : 0,
                    [&keeper] { return keeper.what_is_kept(); });
  FilmKeeper film_keeper = keeper.film_keeper();
  film_keeper.launches = [&](bool are_under_way) { are_under_way ? watchdog.fed() : watchdog.rest(); };
  std::optional<std::string> not_kept;  // The picture is written all the same.
  film_keeper.is_done = [&] { not_kept = keeper.finish(); };
  RenderResult result = renderer.render(
      [&](const Progress& progress) {
        watchdog.fed();
        bar->show(progress);
        return !guard.interrupted();
      },
      goal, &film_keeper);
  if (not_kept) say("strahl: error: " + *not_kept);
  if (!result.numeric_error_fault.empty())
    say(fmt::format("strahl: warning: --aov numeric_error is left out: {}", result.numeric_error_fault));
  canary.note_in(result.stats);
  result.stats.seconds.start = invocation.main_seconds;
  result.stats.seconds.device = device_seconds;
  result.stats.seconds.load = load_seconds;
  const Clipping clipping = write_outputs(options, files, invocation, result);
  const SharedDevice& last = living(shared, result.stats);
  add_rounding(options, invocation, last.device, renderer.scene(), last.settings, guard, result.stats);
  bar.reset();
  result.stats.seconds.exit = expected_exit_seconds(devices);
  result.stats.seconds.total = invocation.seconds() + result.stats.seconds.exit;
  warn_of_dropped(result.stats);
  warn_of_samples(result.stats.unusual);
  say_summary(options, files.path, result, clipping);

  if (!options.stats.empty()) {
    nlohmann::ordered_json detail;
    if (options.stats_detail) made.reset();  // A large film should not be there twice.
    if (options.stats_detail && result.complete)
      detail = count_if_possible(last, counted, options, guard, result.stats);
    auto json = nlohmann::ordered_json::parse(result.stats.json());
    if (options.stats_detail) json["detail"] = detail;
    write_text(options.stats, json_text(json));
  }
  const bool lacks_map = !options.error_map.empty() && !result.error;
  // A complete picture is what was asked for: a signal that came later has ended what is measured beside it alone.
  if (!result.complete) {
    if (not_kept) return ExitCode::failure;
    if (!options.keep.target().empty() && !options.scene.quiet)
      say(fmt::format("strahl: the samples so far are in {}; --resume goes on from there", options.keep.target()));
    return guard.exit_code();
  }
  const std::optional<std::string> missed = missed_goal(options, result);
  if (missed) say("strahl: " + *missed);
  if (not_kept || lacks_map) return ExitCode::failure;
  return ended(missed ? ExitCode::target_missed : ExitCode::ok);
}

void add_output_options(CLI::App& app, RenderOptions& options) {
  const std::string group = "Output";
  app.add_option("-o,--output", options.output, "Picture: .png, .exr or .pfm; default: the scene's name with .png")
      ->type_name("FILE")
      ->group(group);
  require_between(app.add_option("--exposure", options.png.exposure, "PNG: brighter by so many stops"), -64, 64)
      ->type_name("STOPS")
      ->group(group);
  require_whole(app.add_option("--png-bits", options.png.bits, "PNG: 8 or 16 bits a channel"))
      ->type_name("N")
      ->check(CLI::IsMember({8, 16}))
      ->capture_default_str()
      ->group(group);
  app.add_option("--error-map", options.error_map, "Standard error of each pixel: .exr, .pfm, or .png in false colours")
      ->type_name("FILE")
      ->group(group);
  CLI::Option* stats = app.add_option("--stats", options.stats, "Time, rays and memory as JSON; - for standard output")
                           ->type_name("FILE")
                           ->group(group);
  app.add_flag("--stats-detail", options.stats_detail, "Renders a second time with a program that counts, for --stats")
      ->needs(stats)
      ->group(group);
  app.add_flag("--brief", options.brief, "Close with one line: file, seconds, samples, error")->group(group);
  app.add_option("--dump-kernel", options.dump_kernel,
                 "The exact OpenCL program with its options; - for standard output")
      ->type_name("FILE")
      ->group(group);
}

}  // namespace

Command add_render(CLI::App& app, const Invocation& invocation) {
  const auto options = std::make_shared<RenderOptions>();
  add_scene_options(app, options->scene);
  add_device_option(app, options->device, "; several with commas (0,1): each does a part of the picture");
  add_output_options(app, *options);
  add_goal_options(app, options->goal);
  add_keep_options(app, options->keep);
  add_scene_overrides(app, options->overrides);
  add_kernel_options(app, options->kernel);
  add_canary_option(app, options->kernel);
  add_program_options(app, options->kernel);
  add_launch_options(app, options->kernel);
  app.footer(render_footer);
  return [options, &invocation] { return render(*options, invocation); };
}

}  // namespace strahl::cli
