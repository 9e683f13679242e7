// SPDX-License-Identifier: MIT
// Preparations before the first sample: program, buffers, warm-up launches.
#include "render/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>

#include "opencl/compiling.h"
#include "packing/pack_filter.h"
#include "program/path_lanes.h"
#include "render/light_paths.h"
#include "render/numeric_error.h"
#include "render/renderer_state.h"
#include "render/shown_scene.h"
#include "scene/validate.h"
#include "settings/require_settings.h"
#include "stopwatch.h"

namespace strahl {
namespace {

/// Of samples that wait (render/sample_ring.h).
constexpr std::size_t most_ring_bytes = std::size_t{256} << 20;

int most_samples_of(const Scene& scene, const Window& window, const RenderSettings& settings) {
  const bool has_splats = kinds::integrator(scene.integrator.name).from_lights;
  return has_splats ? most_light_paths(window, settings.estimate_error) : max_spp;
}

int samples_of_film(const Scene& scene, const Window& window, const RenderSettings& settings, const RenderGoal& goal) {
  const int most = most_samples_of(scene, window, settings);
  if (!goal.spp && goal.is_open()) return most;
  const int spp = goal.spp.value_or(resolve_sampling(scene).spp);
  if (spp >= 1 && spp <= most) return spp;
  const std::string limit = fmt::format("the film holds 1 to {} samples per pixel", most);
  if (goal.spp) throw UsageError(fmt::format("--spp {}: {}", spp, limit));
  throw SceneError({{Severity::error, scene.sampler.where,
                     fmt::format("sample_count is {}, and {}; state --spp, --time or --max-error", spp, limit)}});
}

}  // namespace

Renderer::State::Choice Renderer::State::choose_program() {
  sampling = resolve_sampling(scene);
  window = scene.film.window();
  Choice choice{wide_enough(width_on(device, settings), scene, settings), {}, 1};
  features = features_of(scene, settings);
  choice.paths = path_lanes(features, settings, choice.width.lanes);
  choice.traversal = choose_traversal(scene, features, settings, choice.width, choice.paths);
  has_tree = choice.traversal.has_tree;
  stats.lanes = choice.width.lanes;
  source = program_source(kinds::integrator(scene.integrator.name).kernel(), features, settings.precision,
                          choice.width.lanes, choice.width.tree, has_tree, choice.paths);
  if (shares_samples()) sharing_source = strahl::sharing_source(features, settings.precision, choice.paths);
  return choice;
}

bool Renderer::State::are_programs_cached() const {
  return strahl::is_program_cached(device, source) &&
         (!sharing_source || strahl::is_program_cached(device, *sharing_source));
}

void Renderer::State::prepare() {
  require_light_paths(scene, settings);
  const Stopwatch start;
  const auto [width, traversal, paths] = choose_program();
  if (settings.aovs.contains(Aov::numeric_error))
    require_numeric_error(device, scene, settings, least_memory(scene, features, settings.precision, width.lanes));
  // Paths of one pixel are more alike than those of a span.
  samples_at_once = paths == 1 ? 1 : layout::POOL_PATHS;
  stats.seconds.program = start.seconds();

  const Stopwatch upload_start;
  buffers = upload_scene(device, scene, features, settings.precision,
                         {width.lanes, frame, width.tree, traversal.acceleration});
  if (row_bytes() > memory_left())
    throw NoDeviceError(
        fmt::format("a row of the picture takes {} KiB beside the scene's {} KiB, and {} has {}: choose {} or a part "
                    "of the picture (--crop)",
                    row_bytes() >> 10, buffers.bytes >> 10, device.info().text(), device.info().memory_text(),
                    device.info().room_for(buffers.bytes + row_bytes())));
  const std::size_t pixels = static_cast<std::size_t>(window.width()) * static_cast<std::size_t>(band_rows());
  if (film_kind() == FilmKind::splats) {
    const std::uint64_t bytes = pixels * film_bytes_per_pixel();
    require_room_for_splats(device.info(), bytes, memory_left());
  }
  aov_reals = allocate(device, aov_real_bytes(pixels), "the auxiliary values");
  aov_ints = allocate(device, aov_int_bytes(pixels), "the auxiliary ids");
  counters = allocate(device, layout::COUNTERS * sizeof(std::uint32_t) + done_bytes(pixels), "the counters");
  // While the program is built.
  film.emplace(device, allocate(device, pixels * film_bytes_per_pixel(), "one band of the film"),
               pixels * film_bytes_per_pixel(film_sums(sampling.spp)));
  stats.seconds.bvh = buffers.tree.seconds;
  stats.seconds.upload = upload_start.seconds() - stats.seconds.bvh;
  stats.device_bytes = buffers.bytes + pixels * film_bytes_per_pixel() + aov_real_bytes(pixels) + aov_int_bytes(pixels);
  stats.host_bytes = stats.scene_bytes = buffers.bytes;

  const Stopwatch program_start;
  ProgramReport report, sharing_report{0, true, 0};
  const auto kernel_of = [&](const ProgramSource& text, const char* name, ProgramReport& how) {
    const cl::Program program = program_on(device, text, &how, settings.cached_program);
    return checked(device.info().text(), [&] { return cl::Kernel(program, name); });
  };
  kernel = kernel_of(source, "render", report);
  shape = LaunchShape(group_limits(device, kernel), paths, settings.work_group);
  if (sharing_source) {
    sharing_kernel = kernel_of(*sharing_source, "share_samples", sharing_report);
    sharing_shape = LaunchShape(group_limits(device, sharing_kernel), paths, settings.work_group);
    ring.emplace(device, taps_of(scene, features).reach, real_bytes());
    static_cast<void>(ring->prepare({0, 0, 1, 1, 0, 1}, 1, ring_memory()));  // A buffer that the kernels can be given.
  }
  warm_up();
  stats.seconds.program += program_start.seconds();
  stats.device = device.info().text();
  stats.precision = precision_name(settings.precision);
  stats.spp = sampling.spp;
  stats.seed = sampling.seed;
  stats.path_lanes = paths;
  stats.tree_width = width.tree;
  stats.tree = buffers.tree;
  stats.program = program_hash(source);
  stats.program_from_cache = report.from_cache && sharing_report.from_cache;
  stats.program_bytes = report.binary_bytes + sharing_report.binary_bytes;
  stats.private_bytes = checked(device.info().text(),
                                [&] { return kernel.getWorkGroupInfo<CL_KERNEL_PRIVATE_MEM_SIZE>(device.device()); });
  stats.texture_lod = features.flag("TEXTURE_LOD");
  stats.disabled.assign(settings.disabled.begin(), settings.disabled.end());
  for (const FeatureReport& row : features.report)
    if (row.on) stats.features.push_back(row.name);
}

int Renderer::State::samples_of(const RenderGoal& goal) const { return samples_of_film(scene, window, settings, goal); }

int Renderer::State::span_columns(const Launch& l) const {
  if (stats.path_lanes == 1 || l.samples < 1) return 1;
  return std::max(1, layout::POOL_PATHS / l.samples);
}

SubSums Renderer::State::sub_sums(const RenderGoal& goal) const {
  const int spp = samples_of(goal);
  if (film_sums(spp) == 1) return {1, 1, 0};
  // Replicates of the whole picture.
  if (film_kind() == FilmKind::splats) return {layout::FILM_SUBSUMS, layout::FILM_SUBSUMS, 0};
  if (sampling.kind == SamplerKind::independent) return {layout::FILM_SUBSUMS, layout::FILM_SUBSUMS, 0};
  // The largest power of two that is at most half of a sequence. With an open goal the length of the sequence is
  // unknown.
  const auto half = static_cast<unsigned>(spp / (2 * layout::SOBOL_SEQUENCES));
  const int turn_bits = static_cast<int>(std::bit_width(half)) - 1;
  return {layout::FILM_SUBSUMS, layout::SOBOL_SEQUENCES, goal.is_open() ? 0 : turn_bits};
}

namespace {

void set_arguments(cl::Kernel& kernel, const std::vector<cl::Buffer>& buffers, const std::vector<int>& values) {
  cl_uint arg = 0;
  for (const cl::Buffer& buffer : buffers) kernel.setArg(arg++, buffer);
  for (const int value : values) kernel.setArg(arg++, value);
}

/// One work-item for each of items x rows.
cl_int run(const Device& device, const cl::Kernel& kernel, const LaunchShape& shape, int items, int rows) {
  const auto round_up = [](int n, int group) { return static_cast<std::size_t>((n + group - 1) / group * group); };
  const WorkGroup group = shape.group(items, rows);
  device.queue().enqueueNDRangeKernel(
      kernel, cl::NullRange, cl::NDRange(round_up(items, group.x), round_up(std::max(rows, 1), group.y)),
      cl::NDRange(static_cast<std::size_t>(group.x), static_cast<std::size_t>(group.y)));
  return device.queue().finish();
}

}  // namespace

void Renderer::State::launch(const Launch& l, const Rows& band) {
  const int span = span_columns(l), items = std::max((l.columns + span - 1) / span, 1);
  std::vector<int> values{scene.film.width,
                          scene.film.height,
                          window.x0 + l.column_first,
                          window.y0 + l.row_first,
                          l.columns,
                          l.rows,
                          span};
  const std::vector<int> of_film =
      film_kind() == FilmKind::splats
          ? std::vector<int>{(l.row_first - band.first) * window.width() + l.column_first, window.width()}
          : std::vector<int>{window.x0, window.y0 + band.first, window.width(), band.count};
  values.insert(values.end(), of_film.begin(), of_film.end());
  values.insert(values.end(), {l.sample_first, l.samples});
  if (film_kind() == FilmKind::pixels)
    values.insert(values.end(), {ring ? ring->ring_row(l.row_first) : 0, ring ? ring->ring_column(l.column_first) : 0,
                                 ring ? ring->rows() : 1, ring ? ring->columns() : 0});
  checked(device.info().text(), [&] {
    set_arguments(kernel,
                  {buffers.geometry, buffers.shading, buffers.index, ring ? ring->buffer() : film->buffer(), aov_reals,
                   aov_ints, counters},
                  values);
    return run(device, kernel, shape, items, l.rows);
  });
}

void Renderer::State::launch_sharing(const Launch& l, const Rows& band) {
  const int span = span_columns(l), items = std::max((l.columns + span - 1) / span, 1);
  checked(device.info().text(), [&] {
    set_arguments(
        sharing_kernel, {buffers.geometry, buffers.shading, buffers.index, film->buffer(), ring->buffer(), counters},
        {l.column_first, l.row_first - band.first, l.columns, l.rows, span, window.width(), l.sample_first, l.samples,
         ring->ring_row_above(l.row_first), ring->ring_column(l.column_first), ring->rows(), ring->columns()});
    return run(device, sharing_kernel, sharing_shape, items, l.rows);
  });
}

std::size_t Renderer::State::ring_memory() const {
  return std::min({most_ring_bytes, static_cast<std::size_t>(device.info().max_allocation), memory_left() / 4});
}

Launch Renderer::State::missing_samples(const Launch& l) { return ring->prepare(l, window.height(), ring_memory()); }

void Renderer::State::begin_ring() {
  if (!features.flag("LOOP_LIMIT")) return;
  const std::size_t words = layout::COUNTERS + ring->pixels(), bytes = words * sizeof(std::uint32_t);
  checked(device.info().text(), [&] {
    if (counters.getInfo<CL_MEM_SIZE>() < bytes) counters = allocate(device, bytes, "the counters");
    device.queue().enqueueFillBuffer(counters, cl_uint{0}, 0, bytes);
    return device.queue().finish();
  });
}

/// Launches without pixels. Runtimes that finish compiling at the first launch do it here, outside of the kernel's
/// time; the second launch shows the overhead of a launch, which is large on llvmpipe.
void Renderer::State::warm_up() {
  {
    const Compiling compiling;
    launch({}, {});
    if (ring) launch_sharing({}, {});
  }
  const Stopwatch start;
  launch({}, {});
  if (ring) launch_sharing({}, {});
  launch_overhead = start.seconds();
}

namespace {

/// What a renderer shows of the scene, which is looked at only where it and the settings are valid.
std::shared_ptr<const Scene> shared(Scene scene, const RenderSettings& settings) {
  require_settings(settings);
  if (std::vector<Diagnostic> problems = validate(scene); !problems.empty()) throw SceneError(problems);
  return std::make_shared<const Scene>(shown_scene(std::move(scene), settings));
}

}  // namespace

Renderer::Renderer(const Device& device, Scene scene, const RenderSettings& settings)
    : state_(std::make_unique<State>(device, shared(std::move(scene), settings), settings)) {
  state_->prepare();
}
Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

void Renderer::share_with(const Device& device, std::optional<std::uint64_t> loop_turns) {
  RenderSettings settings = state_->settings;
  if (settings.precision != Precision::robust && settings.precision != Precision::fp64)
    throw UsageError(
        fmt::format("several devices make one picture in the precisions robust and double; in {} each device has bits "
                    "of its own",
                    precision_name(settings.precision)));
  settings.loop_turns = loop_turns;
  auto helper = std::make_unique<State>(device, state_->shared_scene, settings);
  helper->is_helper = true;
  helper->prepare();
  state_->stats.device += " + " + helper->stats.device;
  state_->stats.device_bytes += helper->stats.device_bytes;
  for (const auto phase : {&PhaseSeconds::bvh, &PhaseSeconds::program, &PhaseSeconds::upload})
    state_->stats.seconds.*phase += helper->stats.seconds.*phase;
  state_->helpers.push_back(std::move(helper));
}

void Renderer::require_samples(const Scene& scene, const RenderSettings& settings, const RenderGoal& goal) {
  require_settings(settings);
  if (std::vector<Diagnostic> problems = validate_picture(scene); !problems.empty()) throw SceneError(problems);
  static_cast<void>(samples_of_film(scene, scene.film.window(), settings, goal));
}

int Renderer::most_samples() const { return most_samples_of(state_->scene, state_->window, state_->settings); }

int Renderer::most_samples(const Scene& scene, const RenderSettings& settings) {
  return most_samples_of(scene, scene.film.window(), settings);
}

const Scene& Renderer::scene() const { return state_->scene; }

std::size_t Renderer::film_bytes_per_pixel() const { return state_->film_bytes_per_pixel(); }

const RunStats& Renderer::stats() const { return state_->stats; }

std::string Renderer::division_text(const RenderGoal& goal) const {
  const SubSums sums = state_->sub_sums(goal);
  return fmt::format("{} sum{} in turns of {}", sums.count, sums.count == 1 ? "" : "s", 1 << sums.turn_bits);
}

std::string Renderer::program_text() const { return completed_for(state_->device, state_->source).text; }

bool Renderer::is_program_cached(const Device& device, const Scene& scene, const RenderSettings& settings) {
  State state(device, shared(scene, settings), settings);
  static_cast<void>(state.choose_program());
  return state.are_programs_cached();
}

std::optional<double> Renderer::build_seconds() const {
  if (state_->stats.program_from_cache) return std::nullopt;
  return state_->stats.seconds.program;
}

bool Renderer::load_program_again() const {
  if (!state_->are_programs_cached()) return false;
  static_cast<void>(build_program(state_->device, state_->source));
  if (state_->sharing_source) static_cast<void>(build_program(state_->device, *state_->sharing_source));
  return true;
}

}  // namespace strahl
