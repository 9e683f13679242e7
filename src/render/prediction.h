// SPDX-License-Identifier: MIT
// Predicts the time and the error of a render from a pilot (render/pilot.h). Many renders are simulated, each with a
// random draw of all uncertain quantities; the interval holds nine of ten of them.
#pragma once

#include <numbers>
#include <optional>
#include <vector>

namespace strahl {

/// Of the simulated runs 5 % end below `low`, half of them below `middle`, 5 % above `high`.
struct Range {
  double low = 0, middle = 0, high = 0;
};
inline constexpr double prediction_confidence = 0.9;

/// Relative standard deviation of the same render's time from run to run on an otherwise idle machine; and of the ratio
/// of two such times, the render's to the pilot's.
inline constexpr double repeat_spread = 0.05, ratio_spread = std::numbers::sqrt2 * repeat_spread;

/// The film's error estimate of a picture, or of a part of one.
struct Look {
  double spp = 0;
  double mse = 0;
  double spread = 0;  ///< Relative standard deviation of `mse`, of what is independent from look to look.
  double upper = 1;   ///< ErrorEstimate of the whole picture: rmse_high over rmse, ...
  double told = 0;    ///< ... and the relative standard deviation of its square.
};

/// Squared error of n samples: mse (n / spp)^-exponent. Spreads are standard deviations, of logarithms but for the
/// exponent's.
struct ErrorTrend {
  double spp = 1, mse = 0, exponent = 1;
  double mse_spread = 0, exponent_spread = 0;
  double told_spread = 0;  ///< Of a picture's own estimate.
  double upper = 1;
};

/// The line through the looks' logarithms, by least squares weighted with their spreads; looks in the order of their
/// samples. common_spread: the spread of the error that all looks share, such as that of the part of the picture.
[[nodiscard]] ErrorTrend error_trend(const std::vector<Look>& looks, double common_spread = 0);

/// The time of a pass of a given number of samples of every pixel.
struct PassCost {
  double samples = 0, seconds = 0;
};

struct RunCosts {
  double start = 0;              ///< Seconds from the start of the process to the first sample, ...
  double start_more = 0;         ///< ... and up to so many more.
  std::vector<PassCost> passes;  ///< In the order of their samples.
  double spread = 0;             ///< Standard deviation of the logarithm of all of them together.
  double look = 0;               ///< One error estimate during the render.
  double end = 0;                ///< From the last sample to the end of the process.
  double extra_share = 0;        ///< Share of all this that may come on top (render/rounding_pilot.h).
};

/// Seconds of a pass of so many samples: between two known ones on the line through them, elsewhere in proportion.
[[nodiscard]] double pass_seconds(const std::vector<PassCost>& passes, double samples);

/// As RenderGoal; `seconds` from the start of the process to its end.
struct PredictedGoal {
  int spp = 1;  ///< What ends it at the latest.
  std::optional<double> max_error;
  std::optional<double> seconds;
};

struct Prediction {
  Range seconds, spp;
  bool has_end = true;        ///< false: an error ends it, and how that falls is not known; nor are seconds and spp.
  std::optional<Range> rmse;  ///< As the picture's bill will state it; none where it cannot be predicted.
};

/// law: none where no look gave an error. The random draws are the same each time.
[[nodiscard]] Prediction predict(const std::optional<ErrorTrend>& law, const RunCosts& costs,
                                 const PredictedGoal& goal);

}  // namespace strahl
