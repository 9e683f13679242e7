// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace strahl {

/// An axis-aligned box: lo x, hi x, lo y, hi y, lo z, hi z.
template <typename Real>
using Bounds = std::array<Real, 6>;

}  // namespace strahl
