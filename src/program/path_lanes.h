// SPDX-License-Identifier: MIT
// How many samples a work-item follows at a time (docs/decisions/0015-paths-in-lanes.md).
#pragma once

#include "program/features.h"
#include "program/program_text.h"
#include "settings/settings.h"

namespace strahl {

/// `lanes` of them, or 1: where settings say so, and where all samples of a pixel are alike.
[[nodiscard]] int path_lanes(const Features& features, const RenderSettings& settings, int lanes);

}  // namespace strahl
