// SPDX-License-Identifier: MIT
// Whether B. Burley's materials draw each lobe that they have about as often as it counts: not where its sampling rate
// is 0. What such a lobe reflects of a sky has to be found by drawing the sky (kinds/lights.h, finds_all_emission()).
#pragma once

#include "scene/model/materials.h"

namespace strahl::kinds {

[[nodiscard]] bool draws_all_lobes(const Principled& bsdf);
[[nodiscard]] bool draws_all_lobes(const PrincipledThin& bsdf);

}  // namespace strahl::kinds
