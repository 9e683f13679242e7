// SPDX-License-Identifier: MIT
// False colours: the map "inferno" of Nathaniel Smith and Stefan van der Walt ("A Better Default Colormap for
// Matplotlib", SciPy 2015; CC0), whose lightness grows evenly. Ten of its entries are joined by straight lines.
#pragma once

#include <array>

namespace strahl {

/// Linear R, G, B for t in [0, 1].
[[nodiscard]] std::array<float, 3> inferno(double t);

}  // namespace strahl
