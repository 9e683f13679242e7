// SPDX-License-Identifier: MIT
// How a program finds hits: in lists, or in a tree.
#pragma once

#include <cstdint>

#include "program/features.h"
#include "program/program_text.h"

namespace strahl {

struct TraversalChoice {
  bool has_tree = false;        ///< The program can walk one.
  Acceleration acceleration{};  ///< What the scene is to be packed with.
};

/// `width` (of the settings, or what suits the device), or where a tree of it could not name that many primitives of a
/// kind and the settings leave it open, 8. Throws UsageError where they name one that is too narrow.
[[nodiscard]] Width wide_enough(Width width, std::int64_t primitives, const RenderSettings& settings);

/// The same for a scene.
[[nodiscard]] Width wide_enough(Width width, const Scene& scene, const RenderSettings& settings);

/// The choice of the settings; where they leave it open, the one that suits the scene. path_lanes: of render.cl, or 1.
[[nodiscard]] TraversalChoice choose_traversal(const Scene& scene, const Features& features,
                                               const RenderSettings& settings, Width width, int path_lanes);

}  // namespace strahl
