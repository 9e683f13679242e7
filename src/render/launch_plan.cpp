// SPDX-License-Identifier: MIT
#include "render/launch_plan.h"

#include <algorithm>
#include <cmath>

namespace strahl {

LaunchPlan::LaunchPlan(int width, int rows, int samples, std::optional<int> passes)
    : width_(width), height_(rows), samples_(samples), passes_(passes) {
  if (passes_) passes_ = std::clamp(*passes_, 1, samples);
}

Launch LaunchPlan::next() {
  if (range_ == 0) {
    const double frames = budget_ / (static_cast<double>(width_) * height_);
    range_ = static_cast<int>(std::clamp(frames, 1.0, static_cast<double>(samples_ - sample_)));
    if (passes_) {
      const auto end = static_cast<std::int64_t>(samples_) * (pass_ + 1) / *passes_;
      range_ = static_cast<int>(end) - sample_;
    }
  }
  const double per_row = static_cast<double>(width_) * range_;
  const int rows = static_cast<int>(std::clamp(budget_ / per_row, 1.0, static_cast<double>(height_ - row_)));
  const Launch launch{row_, rows, sample_, range_};
  issued_ = per_row * rows;
  row_ += rows;
  if (row_ == height_) {
    row_ = 0;
    sample_ += range_;
    range_ = 0;
    ++pass_;
  }
  return launch;
}

void LaunchPlan::measured(double seconds) {
  const double wanted = seconds > 0 ? issued_ * target_seconds / seconds : issued_ * 4;
  budget_ = std::clamp(wanted, 64.0, 4 * std::max(issued_, 64.0));
}

}  // namespace strahl
