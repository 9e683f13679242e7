// SPDX-License-Identifier: MIT
// What a render will take and how far off it will be, from what a pilot has seen (render/pilot.h): many renders are
// imagined, each with a draw of all that is not known for certain, and nine of ten of them span the interval.
#pragma once

#include <optional>
#include <vector>

namespace strahl {

/// Of the runs imagined: 5 % end below `low`, half of them below `middle`, 5 % above `high`.
struct Range {
  double low = 0, middle = 0, high = 0;
};
inline constexpr double prediction_confidence = 0.9;

/// What the film told of a picture, or of a part of one.
struct Look {
  double spp = 0;
  double mse = 0;
  double spread = 0;  ///< Relative standard deviation of `mse`, of what is independent from look to look.
  double upper = 1;   ///< ErrorEstimate of the whole picture: rmse_high over rmse, ...
  double told = 0;    ///< ... and the relative standard deviation of its square.
};

/// Squared error of n samples: mse (n / spp)^-exponent. Spreads are standard deviations, of logarithms but for the
/// exponent's.
struct ErrorLaw {
  double spp = 1, mse = 0, exponent = 1;
  double mse_spread = 0, exponent_spread = 0;
  double told_spread = 0;  ///< Of what a picture tells about itself.
  double upper = 1;
};

/// The line through the looks' logarithms that is nearest by their spreads; looks in the order of their samples.
/// common_spread: of what all looks have in common, as the part of the picture that they are of.
[[nodiscard]] ErrorLaw error_law(const std::vector<Look>& looks, double common_spread = 0);

/// What so many samples of every pixel take in one pass.
struct PassCost {
  double samples = 0, seconds = 0;
};

struct RunCosts {
  double start = 0;              ///< Seconds from the start of the process to the first sample, ...
  double start_more = 0;         ///< ... and up to so many more.
  std::vector<PassCost> passes;  ///< In the order of their samples.
  double spread = 0;             ///< Standard deviation of the logarithm of all of them together.
  double look = 0;               ///< Telling the error on the way.
  double end = 0;                ///< From the last sample to the end of the process.
  double extra_share = 0;        ///< Of all this: what may come on top (render/rounding_pilot.h).
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
  std::optional<Range> rmse;  ///< As the picture's bill will tell it; none where nothing tells it.
};

/// law: none where no look told an error. The same draws each time.
[[nodiscard]] Prediction predict(const std::optional<ErrorLaw>& law, const RunCosts& costs, const PredictedGoal& goal);

}  // namespace strahl
