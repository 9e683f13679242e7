// SPDX-License-Identifier: MIT
// Spectra as linear sRGB by the CIE 1931 standard observer, as Mitsuba 3's RGB variants convert them.
#pragma once

#include "scene/model/vec.h"
#include "scene/spectra/curve.h"

namespace strahl {

/// Of light, so that a constant of 1 from 360 to 830 nm has luminance 1; a component is never negative. A constant is
/// no grey: sRGB's white is D65.
[[nodiscard]] Rgb rgb_of_emission(const SpectrumCurve& curve);
[[nodiscard]] Rgb rgb_of_constant_emission(double value);
/// Of what weighs light (reflectances, indices of refraction), under D65: a constant of 1 from 360 to 830 nm is exactly
/// 1, 1, 1. A component is never negative.
[[nodiscard]] Rgb rgb_of_weight(const SpectrumCurve& curve);

}  // namespace strahl
