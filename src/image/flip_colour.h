// SPDX-License-Identifier: MIT
// The colours of FLIP (Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astrom, Fairchild, "FLIP: A Difference Evaluator
// for Alternating Images", HPG 2020, sections 4.1 and 5.1): linear RGB with the primaries of sRGB, the linearised
// CIELAB called YCxCz, and L*a*b* with Hunt's adjustment, in which differences are taken by the HyAB distance.
#pragma once

#include <array>

namespace strahl {

using Colour = std::array<double, 3>;

[[nodiscard]] Colour ycxcz_from_linear(const Colour& rgb);
[[nodiscard]] Colour linear_from_ycxcz(const Colour& ycxcz);

/// L*, and a*, b* scaled by 0.01 L*: colours count for less where it is dark.
[[nodiscard]] Colour hunt_lab_from_linear(const Colour& rgb);

/// |L1 - L2| + the Euclidean distance of the other two.
[[nodiscard]] double hyab_distance(const Colour& a, const Colour& b);

}  // namespace strahl
