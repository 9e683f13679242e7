// SPDX-License-Identifier: MIT
// How many samples of a pixel a work-item follows at a time (docs/decisions/0015-paths-in-lanes.md).
#pragma once

#include <string>

#include "program/features.h"
#include "program/program_text.h"
#include "settings/settings.h"

namespace strahl {

/// A body that tests one primitive of the kind against rays in lanes (cl/accel/packet_kinds.h).
[[nodiscard]] bool has_packet_body(const std::string& shape_kind);

/// `lanes` of them, or 1: where settings say so, in double precision, where tiers that cannot tell which rays come near
/// a shape would test all of them one by one, and where a pixel has so few samples (`spp`) that most lanes would be
/// idle, or takes them all alike.
[[nodiscard]] int path_lanes(const Features& features, const RenderSettings& settings, int lanes, int spp);

}  // namespace strahl
