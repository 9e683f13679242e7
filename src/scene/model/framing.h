// SPDX-License-Identifier: MIT
// The camera of a scene that has none.
#pragma once

#include <optional>

#include "scene/model/scene.h"

namespace strahl {

/// Looks along -z, y up, with the box inside the picture whatever its aspect; none: a box of size 2 at the origin.
[[nodiscard]] Camera camera_framing(const std::optional<Box>& box);

}  // namespace strahl
