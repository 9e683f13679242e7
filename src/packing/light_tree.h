// SPDX-License-Identifier: MIT
// The binary tree by which points choose among many lights (cl/choosers/tree_lanes.h).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kinds/light_reach.h"

namespace strahl {

/// As cl/scene/layout.h has it: LIGHT_CHILD_..., two children a node, the root first.
struct LightTree {
  std::vector<double> children;     ///< LIGHT_CHILD_REALS each.
  std::vector<std::int32_t> ways;   ///< One a light.
  std::vector<std::int32_t> links;  ///< Two a node.
};

/// Of two lights at least, 2^24 at most. Each node's lights are split where strength times surface times solid angle of
/// both halves is least (A. Conty Estevez, C. Kulla, 2018, equation 1); lights infinitely far away are on a side of
/// their own.
[[nodiscard]] LightTree light_tree(std::span<const LightReach> lights);

}  // namespace strahl
