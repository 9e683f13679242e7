// SPDX-License-Identifier: MIT
// Splits a picture into launches that are short on any device, from measured time. The picture does not depend on it.
#pragma once

#include <limits>
#include <optional>

namespace strahl {

/// A rectangle of a band's pixels and samples [sample_first, sample_first + samples) of each.
struct Launch {
  int column_first = 0;
  int row_first = 0;
  int columns = 0;
  int rows = 0;
  int sample_first = 0;
  int samples = 0;
};

/// Begins with 64 pixel samples and lets each launch take about target_seconds, growing by at most 8 x a step. All
/// pixels get one range of samples before the next range begins; a row is split where it alone would take too long.
class LaunchPlan {
 public:
  static constexpr double target_seconds =
      0.05;  ///< So that launches stay below 0.25 s where the cost of pixels varies.

  /// passes: split the samples into that many ranges regardless of time. overhead_seconds: the time of a launch without
  /// pixels. It counts neither as work nor towards the target; otherwise a slow start would shrink launches to nothing.
  /// samples_at_once: number of samples of a pixel that a work-item takes together, if there are as many; ranges are
  /// multiples of it.
  LaunchPlan(int columns, int rows, int samples, std::optional<int> passes, double overhead_seconds = 0,
             int samples_at_once = 1);

  [[nodiscard]] bool finished() const { return sample_ >= samples_; }
  /// most_seconds: its longest time, as far as it can be predicted.
  [[nodiscard]] Launch next(double most_seconds = std::numeric_limits<double>::infinity());
  /// Seconds that the launch handed out last took.
  void measured(double seconds);
  /// Carries the measured rate to the next band or picture.
  void learn_from(const LaunchPlan& earlier) { budget_ = earlier.budget_; }

 private:
  void choose_range();

  int width_, height_, samples_;
  std::optional<int> passes_;
  double overhead_;
  int samples_at_once_;
  int pass_ = 0;
  int column_ = 0, row_ = 0;  ///< The first pixel not yet handed out in this range of samples.
  int sample_ = 0;            ///< First sample of the current range.
  int range_ = 0;             ///< Samples in the current range; 0: not chosen yet.
  double budget_ = 64;        ///< Pixel samples for the next launch.
  double issued_ = 0;
};

}  // namespace strahl
