// SPDX-License-Identifier: MIT
// HDR-FLIP: Andersson, Nilsson, Shirley, Akenine-Moeller, "Visualizing Errors in Rendered High Dynamic Range Images",
// Eurographics Short Papers 2021: the largest LDR-FLIP of each pixel over a range of exposures that the reference's
// brightest and median pixels decide, tone-mapped by the ACES curve of Narkowicz.
#pragma once

#include "image/flip.h"

namespace strahl {

/// First and last exposure in stops, and how many in equal steps.
struct Exposures {
  double first = 0, last = 0;
  int count = 2;
};

/// `reference`: linear light, not negative. Luminances below 2^-23 count as that: a black one has exposures, too.
[[nodiscard]] Exposures flip_exposures(const RgbChannels& reference);

/// Each pixel's error from 0 to 1; values of linear light, not negative.
[[nodiscard]] Channel hdr_flip_map(const RgbChannels& a, const RgbChannels& reference, double pixels_per_degree);

}  // namespace strahl
