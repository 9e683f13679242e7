// SPDX-License-Identifier: MIT
// Values that are no light (depth, normals, ids ...) as pictures that can be looked at.
#pragma once

#include <string>
#include <vector>

#include "image/image.h"

namespace strahl::cli {

/// The layers of an AOV image ("depth" of "depth.Z", "normal" of "normal.X"), in channel order.
[[nodiscard]] std::vector<std::string> layers(const Image& image);

/// The channels of one layer.
[[nodiscard]] Image layer(const Image& image, const std::string& name);

/// A layer for a PNG: depth divided by its largest value, position scaled per axis to its range (both stated in the
/// metadata), normal as 0.5 + 0.5 n, uv as red and green, ids as false colours, numeric_error by its
/// logarithm; where nothing was hit: black.
[[nodiscard]] Image display(const Image& layer, const std::string& name);

/// A layer for a PFM: its values as they are, in one channel or three (the third 0 where there are two).
[[nodiscard]] Image plain(const Image& layer);

/// Divides by the largest finite value, which goes into the metadata as `key`; returns it (0: nothing to scale).
double scale_to_largest(Image& image, const std::string& key);

}  // namespace strahl::cli
