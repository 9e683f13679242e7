// SPDX-License-Identifier: MIT
// Which channels of two pictures face each other in a comparison.
#pragma once

#include <string>
#include <vector>

#include "image/image.h"

namespace strahl {

/// Indices of the colour channels, in the same order for both pictures.
struct ComparedChannels {
  std::vector<int> a;
  std::vector<int> reference;
};

/// Throws InputError where sizes or colour channels differ, there are no pixels or colour channels, or either picture
/// holds too few values, too many, NaN or infinities (says where).
[[nodiscard]] ComparedChannels comparable_channels(const Image& a, const Image& reference);

}  // namespace strahl
