// SPDX-License-Identifier: MIT
// Which channels of a picture are its colour.
#pragma once

#include <vector>

#include "image/image.h"

namespace strahl {

/// Indices of the first layer's first three channels, alpha left out: one is grey, two are red and green.
[[nodiscard]] std::vector<int> colour_channels(const Image& image);

}  // namespace strahl
