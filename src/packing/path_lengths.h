// SPDX-License-Identifier: MIT
// How many surfaces paths have, and what the last of their rays can find (cl/integrators/last_rays_lanes.h).
#pragma once

#include "kinds/upload_frame.h"
#include "packing/pack.h"

namespace strahl {

/// Of a path, as HEADER_MAX_DEPTH has it: where the integrator follows paths and nothing limits them, ROULETTE_LONGEST
/// more than roulette spares. Hardly any path gets so far; light that is reflected more often is left out.
[[nodiscard]] int most_surfaces(const IntegratorSettings& integrator);

/// HEADER_LAST_DEPTH and the boxes around all emission that rays may hit. Where it may lie in any direction, or where
/// the integrator has no such rays, none is the last. After pack_lights. Instantiated for float and double.
template <typename Real>
void pack_last_rays(PackedScene<Real>& packed, const Scene& scene, const UploadFrame& frame);

}  // namespace strahl
