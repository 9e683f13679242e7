// SPDX-License-Identifier: MIT
// What must hold for the geometry of a shape.
#pragma once

#include <string>
#include <vector>

#include "scene/model/scene.h"

namespace strahl {

/// One sentence for every invariant of scene.h that the geometry breaks.
[[nodiscard]] std::vector<std::string> geometry_faults(const Geometry& geometry);

}  // namespace strahl
