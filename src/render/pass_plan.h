// SPDX-License-Identifier: MIT
// The number of samples that all pixels get before the clock or the error is checked again.
#pragma once

#include <optional>

#include "render/error_estimate.h"
#include "render/goal.h"

namespace strahl {

/// Samples [first, first + count) of every pixel.
struct Pass {
  int first = 0;
  int count = 0;
};

/// How far a plan is.
struct PassPosition {
  int done = 0;                       ///< Samples of every pixel, those of the pass under way included.
  int check_at = 0;                   ///< Samples at which to look at the error.
  std::optional<double> max_error{};  ///< The error to reach that this look is for.
};

/// Whether a picture of this error is done: it is no larger than `wanted`, and the interval's upper end hardly is. A
/// picture of few pixels must not be done by luck.
[[nodiscard]] bool is_reached(const ErrorEstimate& error, double wanted);

/// Without a deadline or an error to reach: one pass. With a deadline: each pass takes two fifths of the time that is
/// left, down to passes of a single sample; only those end part-way, which leaves pixels one sample apart at the most.
/// With an error: up to where the error so far says that it may be reached.
class PassPlan {
 public:
  /// end: samples at which the render ends in any case; first: those that are not to be rendered.
  PassPlan(const RenderGoal& goal, int end, int first = 0);

  /// The next pass; none where one of the goals holds. sample_seconds: what one sample of every pixel takes (0: not
  /// known yet); seconds_left: until the deadline.
  [[nodiscard]] std::optional<Pass> next(double sample_seconds, double seconds_left);
  /// A pass is over. Returns whether the error must be estimated.
  [[nodiscard]] bool wants_error() const { return goal_.max_error && done_ >= check_at_ && ending_ == Ending::samples; }
  void estimated(const std::optional<ErrorEstimate>& error);
  /// Nor will any be told: a sample was not finite. What else is asked for goes on, time or a number of samples.
  void cannot_estimate();
  /// Whether an error to reach may end the render.
  [[nodiscard]] bool is_for_error() const { return goal_.max_error.has_value(); }
  /// Samples of a pixel that would reach the error if they were independent, as far as is known; none before the first
  /// estimate.
  [[nodiscard]] std::optional<int> expected() const { return expected_; }
  /// The reason why next() returned none.
  [[nodiscard]] Ending ending() const { return ending_; }

  [[nodiscard]] PassPosition position() const { return {done_, check_at_, goal_.max_error}; }
  /// As if an earlier plan's passes had been this one's. Where another error is to be reached, it may be reached
  /// already: the first look is at once.
  void go_on_from(const PassPosition& position);

 private:
  RenderGoal goal_;
  int end_;
  int done_ = 0;      ///< Samples of every pixel.
  int check_at_ = 0;  ///< Samples at which to look at the error.
  std::optional<int> expected_;
  Ending ending_ = Ending::samples;
};

}  // namespace strahl
