// SPDX-License-Identifier: MIT
// The error that a tier's rounding adds to a picture. A small version of the picture is rendered twice with the same
// samples: in the tier and in double precision.
#pragma once

#include <functional>
#include <optional>

#include "opencl/device.h"
#include "render/stats.h"
#include "scene/model/scene.h"
#include "settings/settings.h"

namespace strahl {

/// Share of a run's seconds that the pilot may take where it was not asked for.
inline constexpr double rounding_share = 0.05;

/// Pixels of the pilot's longer side, chosen so that it fits into `most_seconds`, as predicted from the run itself; 0:
/// it does not fit. none: no limit. is_built: the double program is in the cache.
[[nodiscard]] int rounding_pilot_side(const RunStats& run, bool is_built, std::optional<double> most_seconds);

/// The settings of the reference: what was chosen for the tier's program may be too much for its own.
[[nodiscard]] RenderSettings in_double_precision(RenderSettings settings);

/// RMSE over linear RGB that rounding adds to a picture of run.spp samples a pixel. Differences that are the same for
/// all seeds count fully; those that average out over samples count as they would with run.spp samples. None where the
/// device has no double precision, the tier is double already, the scene is too large to be uploaded once more, or the
/// pilot would take, or takes, longer than most_seconds, or once goes_on, asked between launches, says no.
[[nodiscard]] std::optional<double> rounding_rmse(const Device& device, const Scene& scene,
                                                  const RenderSettings& settings, const RunStats& run,
                                                  std::optional<double> most_seconds,
                                                  const std::function<bool()>& goes_on = {});

}  // namespace strahl
