// SPDX-License-Identifier: MIT
// Structural similarity: Wang, Bovik, Sheikh, Simoncelli, "Image Quality Assessment: From Error Visibility to
// Structural Similarity", IEEE Transactions on Image Processing 13 (2004): a gaussian window of sigma 1.5 over 11 x 11
// pixels, population covariance, K1 = 0.01, K2 = 0.03, values from 0 to 1.
#pragma once

#include "image/channel.h"

namespace strahl {

/// Width and height that a picture needs at least.
inline constexpr int ssim_window = 11;

/// Each pixel's similarity from -1 to 1, 1 where equal; beyond the border the pictures are mirrored.
[[nodiscard]] Channel ssim_map(const Channel& a, const Channel& b);

/// The mean of a map over the pixels whose window lies inside of the picture.
[[nodiscard]] double mean_ssim(const Channel& map);

}  // namespace strahl
