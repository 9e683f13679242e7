// SPDX-License-Identifier: MIT
// The film is rendered in bands of rows that fit a device buffer; each band in launches that LaunchPlan keeps short.
#include "render/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "device/cl_layout.h"
#include "device/program_text.h"
#include "device/scene_buffers.h"
#include "device/tuned_width.h"
#include "render/aov.h"
#include "render/film.h"
#include "render/launch_plan.h"
#include "render/loop_bound.h"
#include "render/numeric_error.h"
#include "render/stopwatch.h"
#include "scene/validate.h"

namespace strahl {
namespace {

constexpr std::size_t film_bytes_per_pixel = sizeof(std::int64_t) * layout::FILM_SUBSUMS * layout::FILM_CHANNELS;
constexpr std::size_t film_buffer_bytes = std::size_t{256} << 20;

}  // namespace

struct Renderer::State {
  Device device;
  Scene scene;
  RenderSettings settings;
  Features features;
  ProgramSource source;
  ResolvedSampling sampling{};
  Window window;
  SceneBuffers buffers;
  cl::Kernel kernel;
  RunStats stats;  ///< What construction took; render() starts from it.

  State(const Device& d, Scene s, const RenderSettings& r) : device(d), scene(std::move(s)), settings(r) {}

  /// The textbook's renderer keeps the world's coordinates, whatever they cost it.
  [[nodiscard]] Frame frame() const { return settings.precision == Precision::fast ? Frame{} : camera_frame(scene); }
  [[nodiscard]] bool has_aov() const { return features.flag("AOV"); }
  [[nodiscard]] std::size_t real_bytes() const { return settings.precision == Precision::fp64 ? 8 : 4; }
  [[nodiscard]] std::size_t aov_real_bytes(std::size_t pixels) const {
    return has_aov() ? pixels * layout::AOV_REALS * real_bytes() : 0;
  }
  [[nodiscard]] std::size_t aov_int_bytes(std::size_t pixels) const {
    return has_aov() ? pixels * layout::AOV_INTS * sizeof(std::int32_t) : 0;
  }

  /// Rows whose film fits into one buffer.
  [[nodiscard]] int band_rows() const {
    const std::size_t row = static_cast<std::size_t>(window.width()) * film_bytes_per_pixel;
    const std::size_t limit = std::min<std::size_t>(film_buffer_bytes, device.info().max_allocation);
    return static_cast<int>(std::clamp<std::size_t>(limit / row, 1, static_cast<std::size_t>(window.height())));
  }

  void prepare();
  void launch(const Launch& launch, int film_row);
  void warm_up();
  void read_aovs(std::size_t first_pixel, std::size_t pixels, std::vector<double>& reals, std::vector<int>& ints);
  bool render_band(int row, int rows, FilmSums& film, RunStats& run, const std::function<bool()>& report,
                   LaunchPlan& plan);

  double launch_overhead = 0;  ///< Seconds.
  int samples_a_launch = 0;
  cl::Buffer film, aov_reals, aov_ints, counters;
};

void Renderer::State::prepare() {
  if (std::vector<Diagnostic> problems = validate(scene); !problems.empty()) throw SceneError(problems);
  sampling = resolve_sampling(scene);
  window = scene.film.window();
  if (sampling.spp > max_spp)
    throw UsageError(fmt::format("--spp {}: the film holds at most {} samples per pixel", sampling.spp, max_spp));
  if (!settings.estimate_error && sampling.spp > max_spp_in_one_sum)
    throw UsageError(fmt::format("--spp {}: without the error's estimate the film holds at most {} samples per pixel",
                                 sampling.spp, max_spp_in_one_sum));
  if (settings.aovs.contains(Aov::numeric_error) && !device.info().fp64)
    throw NoDeviceError(fmt::format("the AOV numeric_error holds every hit against double precision, which {} has not",
                                    device.info().text()));
  const Width width = width_on(device, settings);
  samples_a_launch =
      most_samples(device, render_loops(scene, width.lanes, acceleration_of(settings)), settings.loop_turns);
  const Stopwatch start;
  features = features_of(scene, settings);
  source = program_source("kernels/render.cl", features, settings.precision, width.lanes, width.tree);
  ProgramReport report;
  const cl::Program program = build_program(device, source, &report);
  kernel = checked(device.info().text(), [&] { return cl::Kernel(program, "render"); });
  stats.seconds.program = start.seconds();

  const Stopwatch upload_start;
  buffers = upload_scene(device, scene, features, settings.precision,
                         {width.lanes, frame(), width.tree, acceleration_of(settings)});
  const std::size_t pixels = static_cast<std::size_t>(window.width()) * static_cast<std::size_t>(band_rows());
  film = allocate(device, pixels * film_bytes_per_pixel, "one band of the film");
  aov_reals = allocate(device, aov_real_bytes(pixels), "the auxiliary values");
  aov_ints = allocate(device, aov_int_bytes(pixels), "the auxiliary ids");
  counters = allocate(device, layout::COUNTERS * sizeof(std::uint32_t), "the counters");
  stats.seconds.bvh = buffers.tree.seconds;
  stats.seconds.upload = upload_start.seconds() - stats.seconds.bvh;
  stats.device_bytes = buffers.bytes + pixels * film_bytes_per_pixel + aov_real_bytes(pixels) + aov_int_bytes(pixels);
  stats.host_bytes = buffers.bytes + static_cast<std::size_t>(window.width()) *
                                         static_cast<std::size_t>(window.height()) * film_bytes_per_pixel;

  const Stopwatch warm_start;
  warm_up();
  stats.seconds.program += warm_start.seconds();
  stats.device = device.info().text();
  stats.precision = precision_name(settings.precision);
  stats.spp = sampling.spp;
  stats.seed = sampling.seed;
  stats.lanes = width.lanes;
  stats.tree_width = width.tree;
  stats.tree = buffers.tree;
  stats.program = program_hash(source);
  stats.program_from_cache = report.from_cache;
  stats.disabled.assign(settings.disabled.begin(), settings.disabled.end());
  for (const FeatureReport& row : features.report)
    if (row.on) stats.features.push_back(row.name);
}

void Renderer::State::launch(const Launch& l, int film_row) {
  const auto round_up = [](int n, int group) { return static_cast<std::size_t>((n + group - 1) / group * group); };
  const WorkGroup group = settings.work_group;
  checked(device.info().text(), [&] {
    cl_uint arg = 0;
    for (const cl::Buffer* buffer :
         {&buffers.geometry, &buffers.shading, &buffers.index, &film, &aov_reals, &aov_ints, &counters})
      kernel.setArg(arg++, *buffer);
    for (const int value : {film_row, l.column_first, l.row_first, l.columns, l.rows, l.sample_first, l.samples})
      kernel.setArg(arg++, value);
    device.queue().enqueueNDRangeKernel(
        kernel, cl::NullRange,
        cl::NDRange(round_up(std::max(l.columns, 1), group.x), round_up(std::max(l.rows, 1), group.y)),
        cl::NDRange(static_cast<std::size_t>(group.x), static_cast<std::size_t>(group.y)));
    return device.queue().finish();
  });
}

/// Launches without pixels: runtimes that finish compiling at the first launch do it here, outside the kernel's time,
/// and the second shows what a launch costs by itself (llvmpipe: tens of milliseconds).
void Renderer::State::warm_up() {
  const std::size_t items =
      static_cast<std::size_t>(settings.work_group.x) * static_cast<std::size_t>(settings.work_group.y);
  if (settings.work_group.x < 1 || settings.work_group.y < 1 || items > device.info().max_work_group)
    throw UsageError(fmt::format("--work-group {}x{}: {} allows 1 to {} work-items", settings.work_group.x,
                                 settings.work_group.y, device.info().text(), device.info().max_work_group));
  launch({}, 0);
  const Stopwatch start;
  launch({}, 0);
  launch_overhead = start.seconds();
}

void Renderer::State::read_aovs(std::size_t first_pixel, std::size_t pixels, std::vector<double>& reals,
                                std::vector<int>& ints) {
  std::vector<std::int32_t> band_ints(pixels * layout::AOV_INTS);
  read_buffer(device, aov_ints, band_ints.data(), aov_int_bytes(pixels));
  std::copy(band_ints.begin(), band_ints.end(),
            ints.begin() + static_cast<std::ptrdiff_t>(first_pixel * layout::AOV_INTS));
  const auto out = reals.begin() + static_cast<std::ptrdiff_t>(first_pixel * layout::AOV_REALS);
  if (settings.precision == Precision::fp64) {
    read_buffer(device, aov_reals, &*out, aov_real_bytes(pixels));
  } else {
    std::vector<float> band_reals(pixels * layout::AOV_REALS);
    read_buffer(device, aov_reals, band_reals.data(), aov_real_bytes(pixels));
    std::copy(band_reals.begin(), band_reals.end(), out);
  }
}

/// false: stopped by the callback; what has been sampled is in the film all the same.
bool Renderer::State::render_band(int row, int rows, FilmSums& sums, RunStats& run, const std::function<bool()>& report,
                                  LaunchPlan& plan) {
  const std::size_t bytes =
      static_cast<std::size_t>(window.width()) * static_cast<std::size_t>(rows) * film_bytes_per_pixel;
  const std::vector<std::uint32_t> zero(layout::COUNTERS, 0);
  checked(device.info().text(), [&] {
    device.queue().enqueueFillBuffer(film, cl_long{0}, 0, bytes);
    if (has_aov()) {  // Pixels without a sample (interrupted) count as missed.
      const std::size_t pixels = bytes / film_bytes_per_pixel;
      device.queue().enqueueFillBuffer(aov_reals, cl_uint{0}, 0, aov_real_bytes(pixels));
      device.queue().enqueueFillBuffer(aov_ints, cl_int{-1}, 0, aov_int_bytes(pixels));
    }
    return device.queue().finish();
  });
  bool carry_on = true;
  while (carry_on && !plan.finished()) {
    write_buffer(device, counters, zero.data(), zero.size() * sizeof(std::uint32_t));
    Launch next = plan.next();
    next.row_first += row;
    const Stopwatch start;
    launch(next, row);
    run.kernel_runs.push_back(start.seconds());
    plan.measured(run.kernel_runs.back());
    std::vector<std::uint32_t> counted(layout::COUNTERS);
    read_buffer(device, counters, counted.data(), counted.size() * sizeof(std::uint32_t));
    run.saturated_samples += counted[layout::COUNT_SATURATED];
    run.invalid_samples += counted[layout::COUNT_INVALID];
    if (settings.count_rays) {
      *run.shadow_rays += counted[layout::COUNT_SHADOW];
      *run.bounce_rays += counted[layout::COUNT_BOUNCE];
      *run.nodes_visited += counted[layout::COUNT_NODES];
      *run.primitives_tested += counted[layout::COUNT_PRIMITIVES];
    }
    sums.add_samples(next);
    run.camera_rays += static_cast<std::uint64_t>(next.columns) * static_cast<std::uint64_t>(next.rows) *
                       static_cast<std::uint64_t>(next.samples);
    run.seconds.kernel += run.kernel_runs.back();
    carry_on = report();
  }
  const Stopwatch start;
  const std::size_t at = static_cast<std::size_t>(row) * static_cast<std::size_t>(window.width());
  read_buffer(device, film, &sums.sums[at * layout::FILM_SUBSUMS * layout::FILM_CHANNELS], bytes);
  run.seconds.readback += start.seconds();
  return carry_on;
}

Renderer::Renderer(const Device& device, Scene scene, const RenderSettings& settings)
    : state_(std::make_unique<State>(device, std::move(scene), settings)) {
  state_->prepare();
}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

std::string Renderer::program_text() const { return state_->source.text; }

RenderResult Renderer::render(const ProgressCallback& progress) {
  State& s = *state_;
  RenderResult result;
  result.stats = s.stats;
  RunStats& run = result.stats;
  if (s.settings.count_rays) run.shadow_rays = run.bounce_rays = run.nodes_visited = run.primitives_tested = 0;
  const int width = s.window.width(), height = s.window.height(), band = s.band_rows();
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  FilmSums film(width, height, s.buffers.film_scale);
  std::vector<double> aov_reals(s.has_aov() ? pixels * layout::AOV_REALS : 0, 0.0);
  std::vector<std::int32_t> aov_ints(s.has_aov() ? pixels * layout::AOV_INTS : 0, -1);
  const Stopwatch start;
  const std::uint64_t total = static_cast<std::uint64_t>(pixels) * static_cast<std::uint64_t>(s.sampling.spp);
  const auto report = [&] { return !progress || progress({run.camera_rays, total, start.seconds()}); };

  std::optional<LaunchPlan> earlier;
  bool carry_on = true;
  for (int row = 0; row < height && carry_on; row += band) {
    const int rows = std::min(band, height - row);
    LaunchPlan plan(width, rows, s.sampling.spp, s.settings.passes, s.launch_overhead, s.samples_a_launch);
    if (earlier) plan.learn_from(*earlier);
    carry_on = s.render_band(row, rows, film, run, report, plan);
    if (s.has_aov())
      s.read_aovs(static_cast<std::size_t>(row) * static_cast<std::size_t>(width),
                  static_cast<std::size_t>(rows) * static_cast<std::size_t>(width), aov_reals, aov_ints);
    earlier = plan;
  }
  const Stopwatch convert;
  result.color = film.mean();
  if (s.settings.aovs.contains(Aov::numeric_error))
    replace_t_by_its_error(s.device, s.scene, s.frame(), s.settings, aov_reals, aov_ints);
  if (!s.settings.aovs.empty())
    result.aov = aov_image(width, height, s.settings.aovs, aov_reals, aov_ints, s.frame());
  else
    result.aov.channels.clear();
  run.seconds.readback += convert.seconds();
  result.complete = run.camera_rays == total;
  return result;
}

}  // namespace strahl
