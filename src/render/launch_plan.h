// SPDX-License-Identifier: MIT
// Splits a picture into launches that are short on any device, from measured time. The picture does not depend on it.
#pragma once

#include <cstdint>
#include <optional>

namespace strahl {

/// Rows [row_first, row_first + rows) of a band, samples [sample_first, sample_first + samples) of each pixel.
struct Launch {
  int row_first = 0;
  int rows = 0;
  int sample_first = 0;
  int samples = 0;
};

/// Begins with a small launch and lets each take about target_seconds, growing by at most 4 x a step. Finishes all
/// rows of a range of samples before the next range.
class LaunchPlan {
 public:
  static constexpr double target_seconds = 0.1;  ///< Launches stay below 0.25 s (a test holds it).

  /// passes: split the samples into that many ranges regardless of time (rows are still split).
  LaunchPlan(int width, int rows, int samples, std::optional<int> passes);

  [[nodiscard]] bool finished() const { return sample_ >= samples_; }
  [[nodiscard]] Launch next();
  /// Seconds that the launch handed out last took.
  void measured(double seconds);
  /// Carries the measured rate to the next band.
  void learn_from(const LaunchPlan& earlier) { budget_ = earlier.budget_; }

 private:
  int width_, height_, samples_;
  std::optional<int> passes_;
  int pass_ = 0;
  int row_ = 0;           ///< First row not yet handed out in this range of samples.
  int sample_ = 0;        ///< First sample of the current range.
  int range_ = 0;         ///< Samples in the current range; 0: not chosen yet.
  double budget_ = 8192;  ///< Pixel samples for the next launch.
  double issued_ = 0;
};

}  // namespace strahl
