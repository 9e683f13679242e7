// SPDX-License-Identifier: MIT
#include "render/film_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include "errors.h"
#include "render/aov.h"
#include "render/numeric_error.h"

namespace strahl {
namespace {

/// Shorter launches cost more than they gain.
constexpr double least_launch_seconds = 0.0005;

/// A part of the film that stays in a processor's cache.
constexpr std::size_t part_bytes = std::size_t{1} << 20;

/// With fewer samples than sub-sums no error can be estimated, and one sum needs a quarter of the memory.
SubSums sub_sums_of(const RenderSettings& settings, SamplerKind sampler, const RenderGoal& goal, int spp) {
  if (!settings.estimate_error || spp < layout::FILM_SUBSUMS) return {1, 1, 0};
  if (sampler == SamplerKind::independent) return {layout::FILM_SUBSUMS, layout::FILM_SUBSUMS, 0};
  // The largest power of two that is at most half of a sequence. With an open goal the length of the sequence is
  // unknown.
  const auto half = static_cast<unsigned>(spp / (2 * layout::SOBOL_SEQUENCES));
  const int turn_bits = static_cast<int>(std::bit_width(half)) - 1;
  return {layout::FILM_SUBSUMS, layout::SOBOL_SEQUENCES, goal.is_open() ? 0 : turn_bits};
}

}  // namespace

/// One sum a pixel that stays on the device is used only for its mean, so the host keeps no copy. Memory takes most of
/// the time of a picture of one sample.
FilmSums FilmRun::black_film() const {
  const SubSums sums = sub_sums_of(state_.settings, state_.sampling.kind, goal_, spp_);
  return {width_, height_, sums, state_.radiance_unit(), !is_one_band() || sums.count > 1};
}

FilmRun::FilmRun(Renderer::State& state, const RenderGoal& goal, const ProgressCallback& progress)
    : state_(state),
      goal_(goal),
      progress_(progress),
      width_(state.window.width()),
      height_(state.window.height()),
      band_rows_(state.band_rows()),
      spp_(state.samples_of(goal)),
      passes_(goal, spp_),
      film_(black_film()) {
  const std::size_t pixels = film_.samples.size();
  aov_reals_.resize(state.has_aov() ? pixels * layout::AOV_REALS : 0, 0.0);
  aov_ints_.resize(state.has_aov() ? pixels * layout::AOV_INTS : 0, -1);
  result_.stats = state.stats;
  result_.stats.host_bytes += film_.words.size() * sizeof(std::int64_t);
  result_.stats.seed = goal.seed.value_or(state.sampling.seed);
  if (state.settings.count_rays)
    result_.stats.shadow_rays = result_.stats.bounce_rays = result_.stats.nodes_visited =
        result_.stats.primitives_tested = 0;
  result_.stats.seconds.readback += construction_.seconds();
}

double FilmRun::seconds_left() const {
  if (!goal_.deadline) return std::numeric_limits<double>::infinity();
  return std::chrono::duration<double>(*goal_.deadline - Clock::now()).count() - state_.finish_seconds.value_or(0);
}

bool FilmRun::report() {
  if (!progress_) return true;
  const std::uint64_t done = result_.stats.camera_rays;
  const double pixels = static_cast<double>(film_.samples.size());
  const double seconds = watch_.seconds();
  std::optional<double> total = pixels * spp_;
  if (goal_.max_error) {
    total.reset();
    if (passes_.expected()) total = pixels * *passes_.expected();
  }
  if (goal_.deadline) {
    const double in_time = static_cast<double>(done) * (seconds + std::max(0.0, seconds_left())) / seconds;
    total = std::min(total.value_or(in_time), in_time);
  }
  return progress_({done, total ? std::max(done, static_cast<std::uint64_t>(*total)) : 0, seconds});
}

void FilmRun::clear(int rows, bool aovs_too) {
  const Stopwatch start;
  const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(rows);
  checked(state_.device.info().text(), [&] {
    const cl::CommandQueue& queue = state_.device.queue();
    queue.enqueueFillBuffer(state_.film, cl_long{0}, 0, film_bytes(pixels));
    if (aovs_too && state_.has_aov()) {  // Pixels without a sample (interrupted) count as missed.
      queue.enqueueFillBuffer(state_.aov_reals, cl_uint{0}, 0, state_.aov_real_bytes(pixels));
      queue.enqueueFillBuffer(state_.aov_ints, cl_int{-1}, 0, state_.aov_int_bytes(pixels));
    }
    if (state_.done_bytes(pixels) > 0)
      queue.enqueueFillBuffer(state_.counters, cl_uint{0}, layout::COUNTERS * sizeof(std::uint32_t),
                              state_.done_bytes(pixels));
    return queue.finish();
  });
  result_.stats.seconds.readback += start.seconds();
}

FilmRun::Unfinished FilmRun::launch_once(const Launch& launch, int band_row) {
  RunStats& run = result_.stats;
  const std::vector<std::uint32_t> zero(layout::COUNTERS, 0);
  write_buffer(state_.device, state_.counters, zero.data(), zero.size() * sizeof(std::uint32_t));
  const Stopwatch start;
  state_.launch(launch, band_row);
  run.kernel_runs.push_back(start.seconds());
  run.seconds.kernel += run.kernel_runs.back();
  std::vector<std::uint32_t> counted(layout::COUNTERS);
  read_buffer(state_.device, state_.counters, counted.data(), counted.size() * sizeof(std::uint32_t));
  run.saturated_samples += counted[layout::COUNT_SATURATED];
  run.invalid_samples += counted[layout::COUNT_INVALID];
  run.weak_branches += counted[layout::COUNT_BRANCHES];
  run.lost_interfaces += counted[layout::COUNT_INTERFACES];
  if (state_.settings.count_rays) {
    *run.shadow_rays += counted[layout::COUNT_SHADOW];
    *run.bounce_rays += counted[layout::COUNT_BOUNCE];
    *run.nodes_visited += counted[layout::COUNT_NODES];
    *run.primitives_tested += counted[layout::COUNT_PRIMITIVES];
  }
  return {counted[layout::COUNT_CUT], counted[layout::COUNT_STUCK]};
}

/// Work-items continue where an earlier launch stopped. Where none makes progress, a part of them is launched alone,
/// because work-items that run in step share their turns.
void FilmRun::launch_to_end(const Launch& launch, int band_row) {
  Unfinished left = launch_once(launch, band_row);
  while (left.cut > left.stuck) left = launch_once(launch, band_row);
  if (left.cut == 0) return;
  Launch first = launch, second = launch;
  if (launch.columns > 1) {
    first.columns = launch.columns / 2;
    second.columns -= first.columns;
    second.column_first += first.columns;
  } else if (launch.rows > 1) {
    first.rows = launch.rows / 2;
    second.rows -= first.rows;
    second.row_first += first.rows;
  } else {
    throw NoDeviceError(fmt::format(
        "{} ends the loops of a work-item after {} turns, and a sample of pixel {}, {} takes more; choose another "
        "device (-d), a smaller max_depth (--max-depth) or fewer shapes",
        state_.device.info().text(), state_.settings.loop_turns.value_or(0), state_.window.x0 + launch.column_first,
        state_.window.y0 + launch.row_first));
  }
  launch_to_end(first, band_row);
  launch_to_end(second, band_row);
}

double FilmRun::launch_and_count(const Launch& launch, int band_row) {
  RunStats& run = result_.stats;
  const double before = run.seconds.kernel;
  launch_to_end(launch, band_row);
  film_.add_samples(launch);
  run.camera_rays += static_cast<std::uint64_t>(launch.columns) * static_cast<std::uint64_t>(launch.rows) *
                     static_cast<std::uint64_t>(launch.samples);
  return run.seconds.kernel - before;
}

/// false: stopped by the callback or, in a pass of single samples, by the deadline.
bool FilmRun::render_band(const Pass& pass, int row, int rows) {
  LaunchPlan plan(width_, rows, pass.count, state_.settings.passes, state_.launch_overhead, state_.samples_at_once);
  if (state_.last_plan) plan.learn_from(*state_.last_plan);
  const double least = least_launch_seconds + state_.launch_overhead;
  bool carry_on = true;
  while (carry_on && !plan.finished()) {
    double most = std::numeric_limits<double>::infinity();
    if (pass.count == 1) {
      const double left = seconds_left();
      if (left < least) {
        is_cut_ = true;
        return false;
      }
      most = std::max(least, left / 2);  // How long a launch takes is known only roughly.
    }
    Launch next = plan.next(most);
    next.row_first += row;
    next.sample_first += pass.first;
    plan.measured(launch_and_count(next, row));
    carry_on = report();
  }
  state_.last_plan = plan;
  return carry_on;
}

void FilmRun::read_band(int row, int rows) {
  const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(rows);
  std::vector<std::int64_t> words(pixels * film_.words_per_pixel());
  read_buffer(state_.device, state_.film, words.data(), film_bytes(pixels));
  film_.add_words(row, words);
}

void FilmRun::read_aovs(int row, int rows) {
  const std::size_t first = static_cast<std::size_t>(row) * static_cast<std::size_t>(width_);
  const std::size_t pixels = static_cast<std::size_t>(rows) * static_cast<std::size_t>(width_);
  read_buffer(state_.device, state_.aov_ints, &aov_ints_[first * layout::AOV_INTS], state_.aov_int_bytes(pixels));
  double* out = &aov_reals_[first * layout::AOV_REALS];
  if (state_.settings.precision == Precision::fp64) {
    read_buffer(state_.device, state_.aov_reals, out, state_.aov_real_bytes(pixels));
  } else {
    std::vector<float> band(pixels * layout::AOV_REALS);
    read_buffer(state_.device, state_.aov_reals, band.data(), state_.aov_real_bytes(pixels));
    std::copy(band.begin(), band.end(), out);
  }
}

/// One band stays on the device from pass to pass; several share a buffer, so each is fetched before the next begins.
bool FilmRun::render_pass(const Pass& pass) {
  bool carry_on = true;
  for (int row = 0; row < height_ && carry_on; row += band_rows_) {
    const int rows = std::min(band_rows_, height_ - row);
    if (!is_one_band() || pass.first == 0) clear(rows, pass.first == 0);
    carry_on = render_band(pass, row, rows);
    const Stopwatch start;
    if (!is_one_band()) read_band(row, rows);
    if (pass.first == 0 && state_.has_aov()) read_aovs(row, rows);
    result_.stats.seconds.readback += start.seconds();
  }
  return carry_on;
}

void FilmRun::read_film() {
  if (!is_one_band() || is_read_in_parts()) return;
  const Stopwatch start;
  read_buffer(state_.device, state_.film, film_.words.data(), film_bytes(film_.samples.size()));
  result_.stats.seconds.readback += start.seconds();
}

Image FilmRun::mean_in_parts() const {
  Image image = film_.black();
  const std::size_t pixels = film_.samples.size(), most = std::max<std::size_t>(1, part_bytes / film_bytes(1));
  std::vector<std::int64_t> part;
  for (std::size_t first = 0; first < pixels; first += most) {
    const std::size_t count = std::min(most, pixels - first);
    part.resize(count * film_.words_per_pixel());
    read_buffer(state_.device, state_.film, part.data(), film_bytes(count), film_bytes(first));
    film_.put_mean(part, first, image);
  }
  return image;
}

void FilmRun::finish() {
  read_film();
  const Stopwatch start;
  result_.color = is_read_in_parts() ? mean_in_parts() : film_.mean();
  result_.stats.seconds.readback += start.seconds();
  const Stopwatch estimating;
  // The error of samples that were clamped to the largest float, or set to 0, is unknown.
  const bool is_whole = result_.stats.saturated_samples + result_.stats.invalid_samples == 0;
  if (state_.settings.estimate_error && is_whole) result_.error = estimate_error(film_);
  result_.standard_error.channels.clear();
  if (state_.settings.error_map) result_.standard_error = standard_error(film_);
  result_.stats.seconds.error += estimating.seconds();
}

/// The time to be reserved for the end is measured: the end is run on a black film, as if it had its samples.
void FilmRun::measure_finish() {
  const Stopwatch start;
  const PhaseSeconds before = result_.stats.seconds;
  clear(std::min(band_rows_, height_), false);
  std::fill(film_.samples.begin(), film_.samples.end(), layout::FILM_SUBSUMS);
  finish();
  std::fill(film_.samples.begin(), film_.samples.end(), 0);
  result_.error.reset();
  result_.stats.seconds = before;
  state_.finish_seconds = start.seconds();
}

RenderResult FilmRun::run() {
  static_assert(layout::HEADER_SUMS == layout::HEADER_SEED + 1 && layout::HEADER_SEQUENCES == layout::HEADER_SEED + 2 &&
                layout::HEADER_TURN_BITS == layout::HEADER_SEED + 3);
  const std::array<cl_int, 4> header = {static_cast<cl_int>(result_.stats.seed), film_.sums.count, film_.sums.sequences,
                                        film_.sums.turn_bits};
  checked(state_.device.info().text(), [&] {
    return state_.device.queue().enqueueWriteBuffer(state_.buffers.index, CL_TRUE, layout::HEADER_SEED * sizeof(cl_int),
                                                    sizeof header, header.data());
  });
  if (goal_.deadline && !state_.finish_seconds) measure_finish();
  bool carry_on = true;
  while (carry_on) {
    const std::optional<Pass> pass = passes_.next(sample_seconds_, seconds_left());
    if (!pass) break;
    const Stopwatch start;
    carry_on = render_pass(*pass);
    sample_seconds_ = start.seconds() / pass->count;
    if (!carry_on || !passes_.wants_error()) continue;
    read_film();
    const Stopwatch estimating;
    passes_.estimated(estimate_error(film_));
    result_.stats.seconds.error += estimating.seconds();
  }
  const Stopwatch finishing;
  finish();
  state_.finish_seconds = finishing.seconds();

  RunStats& run = result_.stats;
  const auto [least, most] = std::minmax_element(film_.samples.begin(), film_.samples.end());
  run.least_spp = *least;
  run.most_spp = *most;
  run.spp = goal_.is_open() ? *most : spp_;
  result_.ending = is_cut_ ? Ending::deadline : carry_on ? passes_.ending() : Ending::stopped;
  // Stopping after the last sample stops nothing.
  if (result_.ending == Ending::stopped && !goal_.is_open() && *least == spp_) result_.ending = Ending::samples;
  result_.complete = result_.ending != Ending::stopped;

  run.ending = ending_name(result_.ending);
  if (result_.error) run.error = ErrorBudget{*result_.error, 0, 0, std::nullopt};
  const Stopwatch convert;
  if (state_.settings.aovs.contains(Aov::numeric_error))
    replace_t_by_its_error(state_.device, state_.scene, state_.frame(), state_.settings, aov_reals_, aov_ints_);
  if (!state_.settings.aovs.empty())
    result_.aov = aov_image(width_, height_, state_.settings.aovs, aov_reals_, aov_ints_, state_.frame());
  else
    result_.aov.channels.clear();
  run.seconds.readback += convert.seconds();
  return std::move(result_);
}

RenderResult Renderer::render(const ProgressCallback& progress, const RenderGoal& goal) {
  if (!goal.rows) return FilmRun(*state_, goal, progress).run();
  /// The window of some rows while they are rendered.
  struct RowsOnly {
    Window& window;
    Window whole = window;
    explicit RowsOnly(Window& w, const Rows& rows) : window(w) {
      window.y0 += rows.first;
      window.y1 = window.y0 + rows.count;
    }
    ~RowsOnly() { window = whole; }
    RowsOnly(const RowsOnly&) = delete;
    RowsOnly& operator=(const RowsOnly&) = delete;
  };
  if (goal.rows->first < 0 || goal.rows->count < 1 || goal.rows->first + goal.rows->count > state_->window.height())
    throw UsageError("rows outside of the picture");
  const RowsOnly only(state_->window, *goal.rows);
  return FilmRun(*state_, goal, progress).run();
}

}  // namespace strahl
