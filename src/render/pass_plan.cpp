// SPDX-License-Identifier: MIT
#include "render/pass_plan.h"

#include <algorithm>
#include <cmath>

#include "packing/cl_layout.h"

namespace strahl {
namespace {

constexpr int sums_a_pixel = layout::FILM_SUBSUMS;

constexpr int first_look = 2 * sums_a_pixel;

/// A pass of several samples is not ended part-way. The share of the time left that it may take: it would have to take
/// 2.5 times as long as the one before it says to miss the deadline. Smaller shares make more passes of few samples,
/// which take longer a sample (docs/decisions/0026-path-pool.md).
constexpr double share_of_time = 0.4;

/// Ratio of the interval's upper end to the wanted error at which a picture is done.
constexpr double tolerated = 1.1;

}  // namespace

bool is_reached(const ErrorEstimate& error, double wanted) {
  return error.rmse <= wanted && error.rmse_high <= tolerated * wanted;
}

PassPlan::PassPlan(const RenderGoal& goal, int end, int first)
    : goal_(goal), end_(end), done_(first), check_at_(first_look) {}

void PassPlan::go_on_from(const PassPosition& position) {
  done_ = std::min(position.done, end_);
  check_at_ = position.max_error == goal_.max_error ? position.check_at : std::max(done_, first_look);
}

std::optional<Pass> PassPlan::next(double sample_seconds, double seconds_left) {
  if (ending_ == Ending::error || ending_ == Ending::unknown_error) return std::nullopt;
  if (done_ >= end_) return std::nullopt;
  if (goal_.deadline && seconds_left <= 0) {
    ending_ = Ending::deadline;
    return std::nullopt;
  }
  int count = end_ - done_;
  if (goal_.max_error) count = std::min(count, check_at_ - done_);
  if (goal_.deadline) {
    const double fitting = sample_seconds > 0 ? share_of_time * seconds_left / sample_seconds : 1;
    count = static_cast<int>(std::clamp(fitting, 1.0, static_cast<double>(count)));
  }
  const Pass pass{done_, count};
  done_ += count;
  return pass;
}

void PassPlan::cannot_estimate() {
  if (!goal_.deadline && !goal_.spp) ending_ = Ending::unknown_error;
  goal_.max_error.reset();
  expected_.reset();
}

void PassPlan::estimated(const std::optional<ErrorEstimate>& error) {
  const double wanted = *goal_.max_error;
  double factor = 2;
  if (error && std::isfinite(error->rmse_high)) {
    if (is_reached(*error, wanted)) {
      ending_ = Ending::error;
      return;
    }
    // Independent samples need the square of the ratio; scrambled sequences need less, so the last step is not taken
    // whole.
    const double ratio = std::max(error->rmse / wanted, error->rmse_high / (tolerated * wanted));
    factor = std::clamp(0.8 * ratio * ratio, 1.15, 4.0);
    expected_ = static_cast<int>(std::min(std::ceil(done_ * std::max(1.0, ratio * ratio)), static_cast<double>(end_)));
  }
  const double next = std::ceil(done_ * factor / sums_a_pixel) * sums_a_pixel;
  check_at_ = static_cast<int>(std::min(next, static_cast<double>(end_)));
}

}  // namespace strahl
