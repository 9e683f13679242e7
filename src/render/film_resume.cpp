// SPDX-License-Identifier: MIT
// A picture that goes on from the film of an earlier run, and the film of one under way.
#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <numeric>

#include "errors.h"
#include "render/film_run.h"

namespace strahl {
namespace {

bool are_alike(const FilmSums& a, const FilmSums& b) {
  return a.kind == b.kind && a.width == b.width && a.height == b.height && a.sums.count == b.sums.count &&
         a.sums.sequences == b.sums.sequences && a.sums.turn_bits == b.sums.turn_bits &&
         a.first_sample == b.first_sample && a.unit == b.unit && a.has_squares == b.has_squares &&
         a.has_own == b.has_own && a.has_weights == b.has_weights;
}

}  // namespace

bool FilmRun::go_on_from(const FilmState& state) {
  const std::vector<int>& has = state.film.samples;
  if (!are_alike(state.film, film_) || state.film.words.size() != has.size() * film_.words_per_pixel() ||
      has.size() != film_.samples.size() || state.aov_reals.size() != aov_reals_.size() ||
      state.aov_ints.size() != aov_ints_.size())
    throw InputError("the film to go on from is of another picture");
  const auto [least, most] = std::minmax_element(has.begin(), has.end());
  if (film_.first_sample + *most > end_)
    throw InputError(fmt::format("the film to go on from has {} samples in a pixel, more than the {} asked for", *most,
                                 end_ - film_.first_sample));
  const Stopwatch start;
  if (!is_one_band()) film_.words = state.film.words;
  film_.samples = has;
  aov_reals_ = state.aov_reals;
  aov_ints_ = state.aov_ints;
  RunStats& run = result_.stats;
  run.unusual = state.unusual;
  samples_before_ = std::accumulate(has.begin(), has.end(), 0.0);
  run.resumed_samples = static_cast<std::uint64_t>(samples_before_);
  // The pass that was under way may be one of hours; where time or an error ends the render, its rest is no part of it.
  const int level = goal_.is_open() ? film_.first_sample + *most : state.position.done;
  passes_.go_on_from({level, state.position.check_at, state.position.max_error});
  has_first_samples_ = film_.first_sample + *least == 0;
  if (is_one_band()) {
    begin_rows(0);
    // Of several bands the device adds to no sums, and the host adds them up.
    write_buffer(state_.device, state_.film->buffer(), state.film.words.data(), film_bytes(has.size()));
    begin_band();
  }
  run.seconds.readback += start.seconds();
  return catch_up(film_.first_sample + *least, std::min(level, end_));
}

/// Brings pixels that are behind up to `level`, those that are furthest behind first, in passes by the clock.
bool FilmRun::catch_up(int least, int level) {
  RenderGoal by_the_clock;
  by_the_clock.deadline = goal_.deadline;
  PassPlan passes(by_the_clock, level, least);
  while (const std::optional<Pass> pass = passes.next(sample_seconds_, seconds_left())) {
    const Stopwatch start;
    const std::uint64_t before = result_.stats.camera_rays;
    has_first_samples_ = pass->first == 0;
    tell_launches(true);
    if (!render_missing(pass->first + pass->count)) return false;
    // As if all pixels had taken part: the next pass may be of more of them.
    const auto rendered = static_cast<double>(std::max<std::uint64_t>(result_.stats.camera_rays - before, 1));
    sample_seconds_ = start.seconds() * static_cast<double>(film_.samples.size()) / rendered;
  }
  is_cut_ = passes.ending() == Ending::deadline;
  return !is_cut_;
}

/// All samples before `end` that pixels have not got; false as render_all_of.
bool FilmRun::render_missing(int end) {
  bool carry_on = true;
  if (is_shared()) {
    const std::vector<Launch> missing = film_.missing(0, height_, end);
    for (std::size_t i = 0; i < missing.size() && carry_on; ++i) carry_on = render_shared(missing[i]);
    return carry_on;
  }
  for (int row = 0; row < height_ && carry_on; row += band_rows_) {
    begin_rows(row);
    const std::vector<Launch> missing = film_.missing(row, band_.count, end);
    if (missing.empty()) continue;
    if (!is_one_band()) {
      clear(band_.count, false);
      begin_band();
    }
    for (std::size_t i = 0; i < missing.size() && carry_on; ++i) carry_on = render_all_of(missing[i]);
    end_band();
  }
  band_ = {};
  return carry_on;
}

/// The values of first samples that the band has by now.
void FilmRun::begin_band() {
  if (!has_first_samples_ || !state_.has_aov()) return;
  const std::size_t first = static_cast<std::size_t>(band_.first) * static_cast<std::size_t>(width_);
  const std::size_t pixels = static_cast<std::size_t>(band_.count) * static_cast<std::size_t>(width_);
  write_buffer(state_.device, state_.aov_ints, &aov_ints_[first * layout::AOV_INTS], state_.aov_int_bytes(pixels));
  const double* reals = &aov_reals_[first * layout::AOV_REALS];
  if (state_.settings.precision == Precision::fp64) {
    write_buffer(state_.device, state_.aov_reals, reals, state_.aov_real_bytes(pixels));
  } else {
    const std::vector<float> floats(reals, reals + pixels * layout::AOV_REALS);
    write_buffer(state_.device, state_.aov_reals, floats.data(), state_.aov_real_bytes(pixels));
  }
}

void FilmRun::give(const std::function<void(FilmState)>& keep, bool is_last) try {
  keep(state_now());
} catch (const std::bad_alloc&) {
  // The film itself is untouched.
  if (!keeper_->no_memory) throw;
  keeper_->no_memory(is_last);
}

FilmState FilmRun::state_now() {
  FilmState state = keeper_ != nullptr && keeper_->spare ? keeper_->spare() : FilmState{};
  if (has_first_samples_ && band_.count > 0 && state_.has_aov()) read_aovs(band_.first, band_.count);
  const RunStats& run = result_.stats;
  static_cast<FilmShape&>(state.film) = film_;
  state.film.samples = film_.samples;
  state.position = passes_.position();
  state.unusual = run.unusual;
  state.aov_reals = aov_reals_;
  state.aov_ints = aov_ints_;
  state.frame = state_.frame;
  std::vector<std::int64_t>& words = state.film.words;
  if (is_one_band()) {  // The only copy, of tens of bytes a pixel and sum.
    words.resize(film_.samples.size() * film_.words_per_pixel());
    read_buffer(state_.device, state_.film->buffer(), words.data(), film_bytes(film_.samples.size()));
  } else {
    words = film_.words;
    if (band_.count > 0) state.film.add_words(band_.first, band_words());
  }
  return state;
}

}  // namespace strahl
