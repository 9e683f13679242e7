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

/// What launches of a device are like.
struct LaunchCosts {
  /// The time of a launch without pixels. It counts neither as work nor towards the target; otherwise a slow start
  /// would shrink launches to nothing.
  double overhead_seconds = 0;
  /// Samples of a pixel that a work-item takes together, if there are as many; ranges are multiples of it.
  int samples_at_once = 1;
  /// Pixels that the device takes together: a launch of fewer is not shorter.
  int items_at_once = 1;
  /// A part of a row takes nearly as long as the row: samples of the rows around it are needed as well.
  bool has_whole_rows = false;
};

/// Begins with 64 pixel samples, or one for each of items_at_once, and lets each launch take about target_seconds,
/// growing by at most 8 x a step. All pixels get one range of samples before the next range begins; a row is split
/// where it alone would take too long, unless it is better whole.
class LaunchPlan {
 public:
  static constexpr double target_seconds =
      0.05;  ///< So that launches stay below 0.25 s where the cost of pixels varies.

  /// passes: split the samples into that many ranges regardless of time.
  LaunchPlan(int columns, int rows, int samples, std::optional<int> passes, const LaunchCosts& costs = {});

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
  LaunchCosts costs_;
  double least_;   ///< Pixels of the smallest launch that is worth it.
  double budget_;  ///< Pixel samples for the next launch.
  int pass_ = 0;
  int column_ = 0, row_ = 0;  ///< The first pixel not yet handed out in this range of samples.
  int sample_ = 0;            ///< First sample of the current range.
  int range_ = 0;             ///< Samples in the current range; 0: not chosen yet.
  double issued_ = 0;
};

}  // namespace strahl
