// SPDX-License-Identifier: MIT
// The end of a picture: what the film says, as an image, its error and AOVs, and how long that takes.
#include <algorithm>
#include <mutex>
#include <optional>

#include "on_threads.h"
#include "render/aov.h"
#include "render/film_parts.h"
#include "render/film_run.h"
#include "render/numeric_error.h"

namespace strahl {

FilmRun::FilmPart FilmRun::part_at(int first, int count) const {
  const int above = first > 0 ? 1 : 0;
  FilmPart part{nullptr, film_.rows(first - above, count + above), first};
  if (!is_one_band()) return part;
  const auto pixel = static_cast<std::size_t>(first - above) * static_cast<std::size_t>(width_);
  const std::size_t per_pixel = film_.words_per_pixel();
  part.on_device = std::make_unique<MappedWords>(state_.device, state_.film->buffer(), pixel * per_pixel,
                                                 part.rows.samples.size() * per_pixel);
  part.rows.words = part.on_device->words();
  return part;
}

void FilmRun::each_part(const std::function<void(const FilmPart&)>& use) const {
  std::mutex device;  // One command at a time: not every runtime takes several.
  const auto release = [&device](const FilmPart* part) {
    const std::lock_guard lock(device);
    delete part;
  };
  const auto take = [&](const Rows& rows) {
    const std::lock_guard lock(device);
    return std::unique_ptr<const FilmPart, decltype(release)>(new FilmPart(part_at(rows.first, rows.count)), release);
  };
  const unsigned threads = film_threads();
  const std::vector<Rows> parts = film_parts(height_, film_bytes(static_cast<std::size_t>(width_)), threads);
  on_threads(parts.size(), threads, [&](std::size_t i) { use(*take(parts[i])); });
}

void FilmRun::finish() {
  // The error of samples that were clamped to the largest float, or set to 0, is unknown.
  const bool is_whole = result_.stats.unusual.not_finite() == 0;
  const bool has_error = state_.settings.estimate_error && is_whole, has_map = state_.settings.error_map;
  const Stopwatch watch;
  std::optional<ErrorSums> error;
  if (has_error || has_map) error.emplace(film_);
  result_.standard_error = has_map ? film_.black() : Image{};
  if (!has_map) result_.standard_error.channels.clear();
  result_.color = film_.black();
  if (film_.has_squares) squares_ = film_.black();
  const double paths = film_.paths_a_pixel();
  std::mutex counting;
  double taking = 0, telling = 0;  // Of all threads.
  each_part([&](const FilmPart& part) {
    const Stopwatch start;
    const FilmRows rows = part.first > 0 ? part.rows.below_first() : part.rows;
    const std::size_t first = static_cast<std::size_t>(part.first) * static_cast<std::size_t>(width_);
    rows.put_mean(first, paths, result_.color);
    if (film_.has_squares) rows.put_squares(first, squares_);
    const double taken = start.seconds();
    if (has_error) error->add(part.rows, part.first);
    if (has_map) error->put_standard_error(rows, first, result_.standard_error);
    const double told = start.seconds() - taken;
    const std::lock_guard lock(counting);
    taking += taken;
    telling += told;
  });
  if (has_error) result_.error = error->tell();
  const double all = watch.seconds(), error_share = taking + telling > 0 ? telling / (taking + telling) : 0;
  result_.stats.seconds.readback += all * (1 - error_share);
  result_.stats.seconds.error += all * error_share;
}

void FilmRun::put_aovs(const std::set<Aov>& plain) {
  const Stopwatch start;
  const FirstSampleValues values{width_, height_, aov_reals_, aov_ints_, state_.frame, film_.first_sample == 0};
  result_.aov = aov_image(values, plain);
  result_.named_aov = aov_image(values, {result_.color, squares_}, state_.settings.aovs.named());
  result_.stats.seconds.readback += start.seconds();
}

Renderer::State::End FilmRun::end() const { return {height_, film_.sums.count, is_one_band()}; }

/// The end is run on a black film, as if it had its samples.
void FilmRun::measure_end() {
  const Stopwatch start;
  const PhaseSeconds before = result_.stats.seconds;
  std::fill(film_.samples.begin(), film_.samples.end(), layout::FILM_SUBSUMS);
  film_.are_counts_weights = true;
  finish();
  put_aovs(state_.settings.aovs.plain());
  std::fill(film_.samples.begin(), film_.samples.end(), 0);
  film_.are_counts_weights = false;
  result_.error.reset();
  result_.stats.seconds = before;
  state_.end_seconds[end()] = start.seconds();
}

/// To be reserved for the end. That of a few rows says nothing about that of all.
double FilmRun::end_seconds() {
  if (!state_.end_seconds.contains(end())) measure_end();
  return state_.end_seconds.at(end());
}

/// false: it could not be told. The picture is done by now, and is what it is without that layer.
bool FilmRun::tell_numeric_error() {
  const Stopwatch start;
  const Renderer::State& device = living_device();
  try {
    replace_t_by_its_error(device.device, state_.scene, state_.frame, device.settings, aov_reals_, aov_ints_);
  } catch (const std::exception& fault) {
    result_.numeric_error_fault = fault.what();
  }
  result_.stats.seconds.error += start.seconds();
  return result_.numeric_error_fault.empty();
}

}  // namespace strahl
