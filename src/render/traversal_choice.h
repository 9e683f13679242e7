// SPDX-License-Identifier: MIT
// How a program finds hits: in lists, or in a tree.
#pragma once

#include "program/features.h"
#include "program/program_text.h"

namespace strahl {

struct TraversalChoice {
  bool has_tree = false;        ///< The program can walk one.
  Acceleration acceleration{};  ///< What the scene is to be packed with.
};

/// The choice of the settings; where they leave it open, the one that suits the scene. path_lanes: of render.cl, or 1.
[[nodiscard]] TraversalChoice choose_traversal(const Scene& scene, const Features& features,
                                               const RenderSettings& settings, Width width, int path_lanes);

}  // namespace strahl
