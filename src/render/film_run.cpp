// SPDX-License-Identifier: MIT
#include "render/film_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "errors.h"
#include "packing/filter_overlap.h"

namespace strahl {
namespace {

/// Shorter launches cost more than they gain.
constexpr double least_launch_seconds = 0.0005;

}  // namespace

/// Memory takes most of the time of a picture of few samples, so the host keeps no copy of what the device has.
FilmSums FilmRun::black_film() const {
  FilmShape shape{state_.film_kind(),   width_, height_, sums_, 0, state_.radiance_unit(), state_.has_squares(),
                  state_.has_own_sums()};
  shape.has_weights = state_.shares_samples();
  if (shape.has_weights) shape.noise_overlap = noise_overlap(state_.scene.film.filter);
  if (goal_.samples) shape.first_sample = goal_.samples->first;
  return FilmSums(shape, !is_one_band());
}

/// Behind the last sample that is asked for.
int FilmRun::end_of_samples() const {
  const int spp = state_.samples_of(goal_);
  if (!goal_.samples) return spp;
  const auto [first, count] = *goal_.samples;
  if (goal_.is_open()) throw UsageError("a part of the samples has a known number of them, not a time or an error");
  if (first < 0 || count < 1 || count > spp - first)
    throw UsageError(
        fmt::format("samples {}:{} are not among the {} of a pixel", first, std::int64_t{first} + count, spp));
  return first + count;
}

FilmRun::FilmRun(Renderer::State& state, const RenderGoal& goal, const ProgressCallback& progress,
                 const FilmKeeper* keeper, std::optional<SubSums> sums)
    : state_(state),
      goal_(goal),
      progress_(progress),
      keeper_(keeper),
      is_part_(sums.has_value()),
      sums_(sums ? *sums : state.sub_sums(goal)),
      width_(state.window.width()),
      height_(state.window.height()),
      band_rows_(state.band_rows()),
      end_(end_of_samples()),
      passes_(goal, end_, goal.samples ? goal.samples->first : 0),
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
  if (is_shared())
    for (std::size_t i = 0; i <= state.helpers.size(); ++i)
      result_.stats.shares.push_back({device_of(i).device.info().text(), 0, 0, device_of(i).fault});
  result_.stats.seconds.readback += construction_.seconds();
}

double FilmRun::seconds_left() const {
  if (!samples_until_) return std::numeric_limits<double>::infinity();
  return std::chrono::duration<double>(*samples_until_ - Clock::now()).count();
}

bool FilmRun::report() {
  if (keeper_ != nullptr && keeper_->is_due && keeper_->is_due()) {
    tell_launches(false);
    give(keeper_->keep, false);
    tell_launches(true);
  }
  if (!progress_) return true;
  const std::uint64_t done = result_.stats.camera_rays + under_way_;
  const double pixels = static_cast<double>(film_.samples.size());
  const double seconds = watch_.seconds();
  // Of this run: what it began with took none of its time.
  const auto of_all_pixels = [&](int samples) { return pixels * (samples - film_.first_sample) - samples_before_; };
  std::optional<double> total = of_all_pixels(end_);
  if (passes_.is_for_error()) {
    total.reset();
    if (passes_.expected()) total = of_all_pixels(*passes_.expected());
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
  state_.film->clear(film_bytes(pixels));
  checked(state_.device.info().text(), [&] {
    const cl::CommandQueue& queue = state_.device.queue();
    if (aovs_too && state_.has_aov()) {  // Pixels without a sample (interrupted) count as missed.
      queue.enqueueFillBuffer(state_.aov_reals, cl_uint{0}, 0, state_.aov_real_bytes(pixels));
      queue.enqueueFillBuffer(state_.aov_ints, cl_int{-1}, 0, state_.aov_int_bytes(pixels));
    }
    if (!state_.ring && state_.done_bytes(pixels) > 0)
      queue.enqueueFillBuffer(state_.counters, cl_uint{0}, layout::COUNTERS * sizeof(std::uint32_t),
                              state_.done_bytes(pixels));
    return queue.finish();
  });
  result_.stats.seconds.readback += start.seconds();
}

/// false: stopped by the callback or, in a pass of single samples, by the deadline. all: pixels and samples, as a
/// launch has them.
bool FilmRun::render_all_of(const Launch& all) {
  LaunchPlan plan(
      all.columns, all.rows, all.samples, state_.settings.passes,
      {state_.launch_overhead, state_.samples_at_once, state_.shape.items_at_once(), state_.ring.has_value()});
  if (state_.last_plan) plan.learn_from(*state_.last_plan);
  const double least = least_launch_seconds + state_.launch_overhead;
  bool carry_on = true;
  while (carry_on && !plan.finished()) {
    double most = std::numeric_limits<double>::infinity();
    if (all.samples == 1) {
      const double left = seconds_left();
      if (left < least) {
        is_cut_ = true;
        return false;
      }
      most = std::max(least, left / 2);  // How long a launch takes is known only roughly.
    }
    Launch next = plan.next(most);
    next.column_first += all.column_first;
    next.row_first += all.row_first;
    next.sample_first += all.sample_first;
    plan.measured(launch_and_count(next));
    carry_on = report();
  }
  state_.last_plan = plan;
  return carry_on;
}

std::vector<std::int64_t> FilmRun::band_words() const {
  const std::size_t pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(band_.count);
  std::vector<std::int64_t> words(pixels * film_.words_per_pixel());
  read_buffer(state_.device, state_.film->buffer(), words.data(), film_bytes(pixels));
  return words;
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

void FilmRun::write_header() {
  static_assert(layout::HEADER_SUMS == layout::HEADER_SEED + 1 && layout::HEADER_SEQUENCES == layout::HEADER_SEED + 2 &&
                layout::HEADER_TURN_BITS == layout::HEADER_SEED + 3 &&
                layout::HEADER_FILM_ROWS == layout::HEADER_SEED + 4);
  const std::array<cl_int, 5> header = {static_cast<cl_int>(result_.stats.seed), film_.sums.count, film_.sums.sequences,
                                        film_.sums.turn_bits, height_};
  checked(state_.device.info().text(), [&] {
    return state_.device.queue().enqueueWriteBuffer(state_.buffers.index, CL_TRUE, layout::HEADER_SEED * sizeof(cl_int),
                                                    sizeof header, header.data());
  });
}

/// One band stays on the device from pass to pass; several share a buffer, so each is fetched before the next begins.
bool FilmRun::render_pass(const Pass& pass) {
  has_first_samples_ = pass.first == 0;
  if (is_shared()) return render_shared({0, 0, width_, height_, pass.first, pass.count});
  bool carry_on = true;
  for (int row = 0; row < height_ && carry_on; row += band_rows_) {
    begin_rows(row);
    if (!is_one_band()) clear(band_.count, has_first_samples_);
    carry_on = render_all_of({0, row, width_, band_.count, pass.first, pass.count});
    end_band();
  }
  return carry_on;
}

void FilmRun::begin_rows(int row) {
  band_ = {row, std::min(band_rows_, height_ - row)};
  // AOVs of rows that were rendered for others' sake are stored only where their band is on the device.
  if (state_.ring) state_.ring->forget();
}

void FilmRun::end_band() {
  const Stopwatch start;
  if (!is_one_band()) film_.add_words(band_.first, band_words());
  if (has_first_samples_ && state_.has_aov()) read_aovs(band_.first, band_.count);
  band_ = {};
  result_.stats.seconds.readback += start.seconds();
}

RenderResult FilmRun::run() {
  if (!is_shared()) write_header();
  // Whatever ends the render, there is a film: of one band on the device, of several on the host.
  if (is_one_band()) clear(height_, true);
  if (goal_.deadline) samples_until_ = later(*goal_.deadline, -end_seconds());
  bool carry_on = true;
  if (keeper_ != nullptr && keeper_->begin_with != nullptr) carry_on = go_on_from(*keeper_->begin_with);
  while (carry_on) {
    tell_launches(false);
    if (passes_.wants_error() && result_.stats.unusual.not_finite() > 0) {
      passes_.cannot_estimate();
    } else if (passes_.wants_error()) {
      const Stopwatch estimating;
      ErrorSums error(film_);
      each_part([&](const FilmPart& part) { error.add(part.rows, part.first); });
      passes_.estimated(error.tell());
      result_.stats.seconds.error += estimating.seconds();
    }
    const std::optional<Pass> pass = passes_.next(sample_seconds_, seconds_left());
    if (!pass) break;
    tell_launches(true);
    const Stopwatch start;
    carry_on = render_pass(*pass);
    sample_seconds_ = start.seconds() / pass->count;
  }
  tell_launches(false);
  const Stopwatch finishing;
  finish();
  const double finish_seconds = finishing.seconds();

  RunStats& run = result_.stats;
  if (state_.ring) run.device_bytes += state_.ring->bytes();
  const auto [least, most] = std::minmax_element(film_.samples.begin(), film_.samples.end());
  run.least_spp = *least;
  run.most_spp = *most;
  run.spp = goal_.is_open() ? *most : end_ - film_.first_sample;
  result_.ending = is_cut_ ? Ending::deadline : carry_on ? passes_.ending() : Ending::stopped;
  // Stopping after the last sample stops nothing.
  if (result_.ending == Ending::stopped && !goal_.is_open() && *least == run.spp) result_.ending = Ending::samples;
  result_.complete = result_.ending != Ending::stopped;

  run.ending = ending_name(result_.ending);
  if (keeper_ != nullptr && keeper_->keep_last) give(keeper_->keep_last, true);
  if (keeper_ != nullptr && keeper_->is_done) keeper_->is_done();
  if (result_.error) run.error = ErrorBudget{*result_.error, 0, 0, std::nullopt};
  std::set<Aov> plain = state_.settings.aovs.plain();
  if (film_.first_sample == 0 && plain.contains(Aov::numeric_error) && (goal_.is_pilot || !tell_numeric_error()))
    plain.erase(Aov::numeric_error);
  const Stopwatch converting;
  put_aovs(plain);
  // Without samples, or where they tell no error, it is shorter than another picture's.
  const bool is_whole = film_.first_sample == 0 && *least >= film_.sums.count && run.unusual.not_finite() == 0;
  if (is_whole) state_.end_seconds[end()] = finish_seconds + converting.seconds();
  return std::move(result_);
}

namespace {

void require_reachable(const RenderGoal& goal, const RenderSettings& settings) {
  if (goal.deadline && !goal.is_pilot && settings.aovs.contains(Aov::numeric_error))
    throw UsageError(
        "the AOV numeric_error traces the scene once more after the last sample, and a deadline leaves no time for it: "
        "leave it out of RenderSettings::aovs, or state spp or max_error in the deadline's place");
  if (!goal.max_error) return;
  if (!(*goal.max_error > 0))
    throw UsageError(fmt::format("an error to reach is greater than 0, and max_error is {}", *goal.max_error));
  if (!settings.estimate_error)
    throw UsageError("without estimate_error no error is told, so that max_error could never be reached: set it");
}

}  // namespace

RenderResult Renderer::render(const ProgressCallback& progress, const RenderGoal& goal, const FilmKeeper* keeper) {
  require_reachable(goal, state_->settings);
  const OneAtATime one(state_->is_rendering);
  if (!goal.rows) return FilmRun(*state_, goal, progress, keeper).run();
  if (!state_->helpers.empty()) throw UsageError("some rows of a picture are rendered by one device");
  if (state_->film_kind() == FilmKind::splats) throw UsageError("light paths end in any row of the picture");
  const auto [first, count] = *goal.rows;
  if (first < 0 || count < 1 || count > state_->window.height() - first)
    throw UsageError("rows outside of the picture");
  const RowsOnly only(state_->window, *goal.rows);
  return FilmRun(*state_, goal, progress, keeper).run();
}

}  // namespace strahl
