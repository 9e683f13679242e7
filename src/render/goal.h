// SPDX-License-Identifier: MIT
// When a picture is done.
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>

namespace strahl {

using Clock = std::chrono::steady_clock;

/// No further than 31 years off, and from a time within half of what a clock of 64-bit nanoseconds holds, so that it
/// holds what comes out, and how long that is from now. No number: the time itself.
[[nodiscard]] inline Clock::time_point later(Clock::time_point time, double seconds) {
  constexpr Clock::time_point latest{Clock::duration::max() / 2}, earliest{Clock::duration::min() / 2};
  const std::chrono::duration<double> span(std::isnan(seconds) ? 0 : std::clamp(seconds, -1e9, 1e9));
  return std::clamp(time, earliest, latest) + std::chrono::duration_cast<Clock::duration>(span);
}

/// Some rows of a picture, counted from its window's first.
struct Rows {
  int first = 0;
  int count = 0;
};

/// Some samples of every pixel.
struct SampleRange {
  int first = 0;
  int count = 0;
};

/// Whatever holds first ends the render.
struct RenderGoal {
  /// Samples a pixel; none: the number that the scene states, or with one of the two goals below as many as needed.
  std::optional<int> spp;
  /// The time by which render() must have returned. Pixels then differ by one sample at the most. Not with
  /// Aov::numeric_error, which is traced after the last sample.
  std::optional<Clock::time_point> deadline;
  /// RMSE over linear RGB, all pixels and channels, as the film's sub-sums tell it (error_estimate.h): a number > 0,
  /// and not without RenderSettings::estimate_error, for no sum would tell it.
  std::optional<double> max_error;
  std::optional<std::uint32_t> seed;  ///< None: the scene's.
  std::optional<Rows> rows;           ///< A picture of these rows alone, which it has; none: of all rows.
  /// Only these of the samples: a part that adds up with others to the picture of `spp` samples. Not with an open goal.
  std::optional<SampleRange> samples;
  /// Nobody looks at its layers: numeric_error is left out, which takes longer than a few rows.
  bool is_pilot = false;

  [[nodiscard]] bool is_open() const { return deadline || max_error; }
};

/// What ended a render. unknown_error: with the error as the only goal, that a sample was not finite, so that no error
/// can be told.
enum class Ending { samples, deadline, error, unknown_error, stopped };

[[nodiscard]] constexpr const char* ending_name(Ending ending) {
  switch (ending) {
    case Ending::samples:
      return "samples";
    case Ending::deadline:
      return "deadline";
    case Ending::error:
      return "error";
    case Ending::unknown_error:
      return "unknown error";
    case Ending::stopped:
      break;
  }
  return "stopped";
}

}  // namespace strahl
