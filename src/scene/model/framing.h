// SPDX-License-Identifier: MIT
// What a camera or a projector takes in; the camera of a scene that has none.
#pragma once

#include <optional>

#include "scene/model/scene.h"

namespace strahl {

/// Looks along -z, y up, with the box inside the picture whatever its aspect; none: a box of size 2 at the origin.
[[nodiscard]] Camera camera_framing(const std::optional<Box>& box);

/// Half the opening's tangent, across the width of a picture.
[[nodiscard]] double tan_half_width(double fov_degrees, FovAxis axis, double width, double height);

}  // namespace strahl
