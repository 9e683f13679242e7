// SPDX-License-Identifier: MIT
// The error of a picture by cause, which shows what more time would buy.
#pragma once

#include <optional>
#include <string>

#include "render/error_estimate.h"

namespace strahl {

/// RMSE over linear RGB of each cause alone.
struct ErrorBudget {
  ErrorEstimate noise;                 ///< Caused by too few samples.
  double output = 0;                   ///< Of the file's 8 or 16 bits.
  double clipping = 0;                 ///< Of values outside [0, 1] in such a file: no time buys it back.
  std::optional<double> rounding;      ///< Of the tier's floats; none: not measured.
  std::string unmeasured = "-v does";  ///< Why, or what would.

  /// Of all causes except clipping. The causes are independent, so their squares add up.
  [[nodiscard]] double rmse() const { return with(noise.rmse); }
  [[nodiscard]] double rmse_low() const { return with(noise.rmse_low); }
  [[nodiscard]] double rmse_high() const { return with(noise.rmse_high); }

 private:
  [[nodiscard]] double with(double noise_rmse) const;
};

}  // namespace strahl
