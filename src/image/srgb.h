// SPDX-License-Identifier: MIT
// The sRGB transfer curve, exact and piecewise (IEC 61966-2-1:1999), not the power 2.2 that resembles it.
#pragma once

#include <algorithm>
#include <cmath>

namespace strahl {

/// Linear light in [0, 1] to the encoded value in [0, 1].
[[nodiscard]] inline double srgb_from_linear(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

/// Encoded value in [0, 1] to linear light in [0, 1].
[[nodiscard]] inline double linear_from_srgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// What a display is sent for any linear value: clamped to [0, 1] and encoded.
[[nodiscard]] inline double display_value(double linear) { return srgb_from_linear(std::clamp(linear, 0.0, 1.0)); }

}  // namespace strahl
