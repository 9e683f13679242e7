// SPDX-License-Identifier: MIT
// LDR-FLIP: how large a difference looks when two pictures are flipped between. Andersson, Nilsson, Akenine-Moeller,
// Oskarsson, Astrom, Fairchild, "FLIP: A Difference Evaluator for Alternating Images", HPG 2020; filters in two passes
// as in the authors' "Separated Convolutions for FLIP".
#pragma once

#include <array>

#include "image/channel.h"

namespace strahl {

/// R, G and B of linear light.
using RgbChannels = std::array<Channel, 3>;

/// How near the eye is: the authors' 0.7 m before a display that is 0.7 m and 3840 pixels wide, about 67.
inline constexpr double default_pixels_per_degree = 3840 * 3.14159265358979323846 / 180;

/// Each pixel's error from 0 to 1. Values must lie in [0, 1].
[[nodiscard]] Channel flip_map(const RgbChannels& a, const RgbChannels& reference, double pixels_per_degree);

}  // namespace strahl
