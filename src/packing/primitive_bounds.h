// SPDX-License-Identifier: MIT
// Boxes around primitives as the device holds them, rounded outwards.
#pragma once

#include <string>

#include "kinds/bounds.h"
#include "scene/model/vec.h"

namespace strahl {

/// Not smaller than lo ... hi. Instantiated for float and double.
template <typename Real>
[[nodiscard]] Bounds<Real> rounded_outwards(const Vec3& lo, const Vec3& hi);

/// From the planes of a primitive (cl/shapes/shapes.def). Nullptr: the kind has no bounds.
template <typename Real>
using BoundsFunction = Bounds<Real> (*)(const Real* planes);

/// Throws std::out_of_range for a kind that is in no list. Instantiated for float and double.
template <typename Real>
[[nodiscard]] BoundsFunction<Real> bounds_function(const std::string& kind);

}  // namespace strahl
