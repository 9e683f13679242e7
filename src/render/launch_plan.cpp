// SPDX-License-Identifier: MIT
#include "render/launch_plan.h"

#include <algorithm>
#include <cstdint>

namespace strahl {

LaunchPlan::LaunchPlan(int columns, int rows, int samples, std::optional<int> passes, double overhead_seconds,
                       int samples_at_once)
    : width_(columns),
      height_(rows),
      samples_(samples),
      passes_(passes),
      overhead_(overhead_seconds),
      samples_at_once_(samples_at_once) {
  if (passes_) passes_ = std::clamp(*passes_, 1, samples);
}

void LaunchPlan::choose_range() {
  if (passes_) {
    const std::int64_t end = static_cast<std::int64_t>(samples_) * (pass_ + 1) / *passes_;
    range_ = static_cast<int>(end) - sample_;
  } else {
    const double frames = budget_ / (static_cast<double>(width_) * height_ * samples_at_once_);
    const int most = samples_ - sample_;
    range_ = std::min(most, samples_at_once_ * static_cast<int>(std::clamp(frames, 1.0, static_cast<double>(most))));
  }
}

Launch LaunchPlan::next(double most_seconds) {
  if (range_ == 0) choose_range();
  Launch launch{column_, row_, width_ - column_, 1, sample_, range_};
  const double budget = budget_ * std::min(1.0, most_seconds / target_seconds);
  const double pixels = std::max(budget / range_, 1.0);
  if (pixels < launch.columns)
    launch.columns = static_cast<int>(pixels);
  else if (column_ == 0)
    launch.rows = static_cast<int>(std::clamp(pixels / width_, 1.0, static_cast<double>(height_ - row_)));
  issued_ = static_cast<double>(launch.columns) * launch.rows * launch.samples;

  column_ += launch.columns;
  if (column_ == width_) {
    column_ = 0;
    row_ += launch.rows;
  }
  if (row_ == height_) {
    row_ = 0;
    sample_ += range_;
    range_ = 0;
    ++pass_;
  }
  return launch;
}

void LaunchPlan::measured(double seconds) {
  const double work = seconds - overhead_;
  const double most = 8 * std::max(issued_, 64.0);
  // Where the work is smaller than the noise of the overhead, the only conclusion is that a launch may have more work.
  const double fitting = work > 0.1 * overhead_ ? std::clamp(issued_ * target_seconds / work, 1.0, most) : most;
  // A few remaining pixels at the end of a row say little about the cost of a pixel.
  const bool is_remainder = issued_ < 0.5 * budget_;
  budget_ = is_remainder ? std::min(budget_, fitting) : fitting;
}

}  // namespace strahl
