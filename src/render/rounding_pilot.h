// SPDX-License-Identifier: MIT
// What the floats of a tier add to a picture's error, told by rendering it small twice, with the same samples: in the
// tier, and in double precision.
#pragma once

#include <optional>

#include "opencl/device.h"
#include "render/stats.h"
#include "scene/model/scene.h"
#include "settings/settings.h"

namespace strahl {

/// Of a run's seconds: what the pilot may take where nobody asked for it.
inline constexpr double rounding_share = 0.05;

/// Pixels of the pilot's longer side, so that it fits into `most_seconds` by what the run itself took; 0: it does not.
/// none: whatever it takes. is_built: the double program is in the cache.
[[nodiscard]] int rounding_pilot_side(const RunStats& run, bool is_built, std::optional<double> most_seconds);

/// RMSE over linear RGB that rounding adds to a picture of run.spp samples a pixel. Differences that stay the same from
/// seed to seed count whole, those that samples average out count as run.spp of them would. None where the device has
/// no double precision, the tier is double already, the scene is too large to be uploaded once more, or the pilot would
/// take, or takes, longer than most_seconds.
[[nodiscard]] std::optional<double> rounding_rmse(const Device& device, const Scene& scene,
                                                  const RenderSettings& settings, const RunStats& run,
                                                  std::optional<double> most_seconds);

}  // namespace strahl
