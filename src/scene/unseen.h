// SPDX-License-Identifier: MIT
// Surfaces that nothing, or only a share, is seen of, and those that a priority ranks.
#pragma once

#include "scene/model/scene.h"

namespace strahl {

/// Whether all light passes the shape as it came, and it emits none: a null material everywhere. Such a shape may be a
/// boundary of media.
[[nodiscard]] bool is_unseen(const Shape& shape, const Scene& scene);

/// Whether a share of the light may pass the shape as it came.
[[nodiscard]] bool is_masked(const Shape& shape, const Scene& scene);

/// Whether the shape bounds media, and at least a share of the light goes straight through it: by a null material or a
/// mask, or as thin glass. Such a shape may have a priority.
[[nodiscard]] bool is_passed_boundary(const Shape& shape, const Scene& scene);

/// Whether a priority ranks the shape as glass; of a mesh with parts, any of them. mesh: what is or will be the shape's
/// geometry; null: that is none.
[[nodiscard]] bool has_glass(const Shape& shape, const Mesh* mesh, const Scene& scene);

/// Whether a priority of the shape, which is complete, has an effect.
[[nodiscard]] bool is_ranked(const Shape& shape, const Scene& scene);

/// Whether there is a material of thin glass. What goes straight through it is no event to volpath.
[[nodiscard]] bool has_panes(const Scene& scene);

}  // namespace strahl
