// SPDX-License-Identifier: MIT
#include "render/launch_plan.h"

#include <algorithm>
#include <cstdint>

namespace strahl {
namespace {

/// Pixel samples.
constexpr double first_budget = 64;

}  // namespace

LaunchPlan::LaunchPlan(int columns, int rows, int samples, std::optional<int> passes, const LaunchCosts& costs)
    : width_(columns),
      height_(rows),
      samples_(samples),
      passes_(passes),
      costs_(costs),
      least_(std::min(static_cast<double>(columns) * rows, static_cast<double>(costs.items_at_once))),
      budget_(std::max(first_budget, least_)) {
  if (passes_) passes_ = std::clamp(*passes_, 1, samples);
}

void LaunchPlan::choose_range() {
  if (passes_) {
    const std::int64_t end = static_cast<std::int64_t>(samples_) * (pass_ + 1) / *passes_;
    range_ = static_cast<int>(end) - sample_;
  } else {
    const double frames = budget_ / (static_cast<double>(width_) * height_ * costs_.samples_at_once);
    const int most = samples_ - sample_;
    range_ =
        std::min(most, costs_.samples_at_once * static_cast<int>(std::clamp(frames, 1.0, static_cast<double>(most))));
  }
}

Launch LaunchPlan::next(double most_seconds) {
  if (range_ == 0) choose_range();
  Launch launch{column_, row_, width_ - column_, 1, sample_, range_};
  const double budget = std::max(budget_ * std::min(1.0, most_seconds / target_seconds), least_);
  // Of fewer pixels than the device takes together, a launch of many samples is no shorter.
  const double pixels = std::max(budget / range_, least_);
  if (pixels < launch.columns && !costs_.has_whole_rows)
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
  const double work = seconds - costs_.overhead_seconds;
  const double most = 8 * std::max({issued_, first_budget, least_});
  // Where the work is smaller than the noise of the overhead, the only conclusion is that a launch may have more work.
  const double fitting =
      work > 0.1 * costs_.overhead_seconds ? std::clamp(issued_ * target_seconds / work, least_, most) : most;
  // A few remaining pixels at the end of a row say little about the cost of a pixel.
  const bool is_remainder = issued_ < 0.5 * budget_;
  budget_ = is_remainder ? std::min(budget_, fitting) : fitting;
}

}  // namespace strahl
