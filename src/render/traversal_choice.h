// SPDX-License-Identifier: MIT
// How a program finds what rays meet: in lists, or in a tree.
#pragma once

#include "device/features.h"
#include "device/program_text.h"
#include "render/loop_bound.h"

namespace strahl {

struct TraversalChoice {
  bool has_tree = false;        ///< The program can walk one.
  Acceleration acceleration{};  ///< What the scene is to be packed with.
  LoopBound loops;
};

/// What the settings say. Where they leave it open: what suits the scene, but lists where a device ends loops before
/// one sample is sure to be through the tree; what it takes at most is far more than it ever takes. loops: render_loops
/// or intersect_loops.
[[nodiscard]] TraversalChoice choose_traversal(const Scene& scene, const Features& features,
                                               const RenderSettings& settings, Width width,
                                               LoopBound (*loops)(const Scene&, int lanes, Acceleration));

}  // namespace strahl
