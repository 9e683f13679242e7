// SPDX-License-Identifier: MIT
// How many samples a work-item follows at a time (docs/decisions/0015-paths-in-lanes.md).
#pragma once

#include <string>

#include "program/features.h"
#include "program/program_text.h"
#include "settings/settings.h"

namespace strahl {

/// A body that tests one primitive of the kind against rays in lanes (cl/accel/packet_kinds.h).
[[nodiscard]] bool has_packet_body(const std::string& shape_kind);

/// `lanes` of them, or 1: where settings say so, in double precision, where tiers that cannot tell which rays come near
/// a shape would test all of them one by one, and where all samples of a pixel are alike.
[[nodiscard]] int path_lanes(const Features& features, const RenderSettings& settings, int lanes);

}  // namespace strahl
