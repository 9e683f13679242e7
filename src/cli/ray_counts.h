// SPDX-License-Identifier: MIT
// --stats-detail: the second run, which counts.
#pragma once

#include <nlohmann/json.hpp>

#include "cli/interrupt.h"
#include "cli/render_options.h"
#include "cli/shared_devices.h"
#include "render/stats.h"
#include "scene/model/scene.h"

namespace strahl::cli {

/// Puts what was counted into `stats`, those of the run that made the picture, and returns what the counting run was.
/// Null where that fails: the picture is written by now, and the statistics of its run are what they are.
[[nodiscard]] nlohmann::ordered_json count_if_possible(const SharedDevice& on, const Scene& scene,
                                                       const RenderOptions& options, const InterruptGuard& guard,
                                                       RunStats& stats);

}  // namespace strahl::cli
