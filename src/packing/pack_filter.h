// SPDX-License-Identifier: MIT
// The film and its filter as the kernels read them (cl/scene/layout.h, HEADER_FILM_ROWS, HEADER_FILTER to
// HEADER_TAP_REACH).
#pragma once

#include "kinds/filter_taps.h"
#include "packing/packed_scene.h"
#include "program/features.h"

namespace strahl {

/// What a program of these features weighs samples by. Reach 0 unless it shares them among pixels, and where all of
/// them lie in the pixels' centres.
[[nodiscard]] kinds::FilterTaps taps_of(const Scene& scene, const Features& features);

/// Instantiated for float and double.
template <typename Real>
void pack_film(PackedScene<Real>& packed, const Scene& scene, const Features& features);

}  // namespace strahl
