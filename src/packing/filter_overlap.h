// SPDX-License-Identifier: MIT
// How much of their noise pixels have in common whose filters overlap.
#pragma once

#include "scene/model/scene.h"

namespace strahl {

/// The sum, over all pixels, of the squared correlation of their noise with one pixel's, where every sample counts in
/// all pixels that the filter reaches and the samples' variance changes slowly: 1 of a box of one pixel, 1.6 of
/// Mitsuba's gaussian.
[[nodiscard]] double noise_overlap(const Filter& filter);

}  // namespace strahl
