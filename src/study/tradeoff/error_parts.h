// SPDX-License-Identifier: MIT
// The error of a setting, taken apart: what repeating it with other seeds would average out, and what it would not.
//
// Pictures x_k of K seeds, their mean m and unbiased variance s^2 a pixel and channel, reference r with an error of
// variance v of its own: E (x_k - r)^2 = bias^2 + variance + v. Hence with means over pixels and channels
//   variance = mean s^2,   bias^2 = mean (m - r)^2 - variance / K - v,   mse = mean (x_k - r)^2.
// Seeds are the only thing drawn: pixels are strata, so the spread over seeds within each of them says how far the mean
// over all of them is off (W. G. Cochran, "Sampling Techniques", 1977, chapter 5).
#pragma once

#include <vector>

#include "image/image.h"

namespace strahl {

struct ErrorParts {
  double mse = 0;          ///< Against the reference as it is, its own error included.
  double mse_error = 0;    ///< Standard error of mse.
  double variance = 0;     ///< Of one picture.
  double bias2 = 0;        ///< Estimates below 0 count as 0: then nothing was found.
  double bias2_error = 0;  ///< Standard error of bias2.
  [[nodiscard]] double rmse() const;
  [[nodiscard]] double rmse_low() const;  ///< 95 %, of the RMSE to be expected of one picture.
  [[nodiscard]] double rmse_high() const;
};

/// pictures: at least two, of different seeds. reference_variance: v, 0 where it is unknown. Throws InputError where
/// sizes or colour channels differ or a value is not finite.
[[nodiscard]] ErrorParts error_parts(const std::vector<Image>& pictures, const Image& reference,
                                     double reference_variance);

}  // namespace strahl
