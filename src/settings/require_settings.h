// SPDX-License-Identifier: MIT
// Settings that no scene and no device could be rendered with.
#pragma once

#include "settings/settings.h"

namespace strahl {

/// Throws UsageError, with the value and what may stand in its place, where `lanes`, `bvh_width`, both together,
/// `passes` or `aovs` are none of what RenderSettings states.
void require_settings(const RenderSettings& settings);

/// Whether a kernel tests so many primitives at a time in that precision.
[[nodiscard]] bool is_lane_count(int lanes, Precision precision);

/// Whether nodes have so many children in that precision.
[[nodiscard]] bool is_tree_width(int width, Precision precision);

/// How many primitives are tested at a time in a tree of that width.
[[nodiscard]] constexpr int lanes_of_tree(int width) { return width >= 8 ? width : 1; }

}  // namespace strahl
