// SPDX-License-Identifier: MIT
// How far and which way a light shines: what chooses among lights (cl/choosers).
#pragma once

#include <numbers>

#include "kinds/extent.h"

namespace strahl {

/// By luminance, in the units of the upload frame.
struct LightReach {
  double intensity = 0;  ///< W/sr in the direction in which it is brightest; of a far light its irradiance, W/m^2.
  double power = 0;      ///< W; of a far light its irradiance until who knows the scene's size multiplies it.
  bool is_far = false;   ///< As LightFacts has it.
  kinds::Extent extent;  ///< Around all places that it shines from; of a far light nothing.
  Vec3 axis{0, 0, 1};    ///< Unit. Its places shine about axes that are at most `spread` from this one ...
  double spread = std::numbers::pi;  ///< (radians)
  double cutoff = std::numbers::pi;  ///< ... and at most so far from their own axis.
  double weight = 1;                 ///< Multiplies its chance: sampling_weight.
};

/// The luminance of linear sRGB, as the kernels have it.
[[nodiscard]] inline double luminance(const Rgb& c) { return 0.212671 * c.r + 0.71516 * c.g + 0.072169 * c.b; }

}  // namespace strahl
