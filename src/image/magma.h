// SPDX-License-Identifier: MIT
// False colours: the map "magma" of Nathaniel Smith and Stefan van der Walt ("A Better Default Colormap for
// Matplotlib", SciPy 2015; CC0), in which FLIP is shown. Sixteen of its entries are joined by straight lines.
#pragma once

#include <array>

namespace strahl {

/// Linear R, G, B for t in [0, 1].
[[nodiscard]] std::array<float, 3> magma(double t);

}  // namespace strahl
