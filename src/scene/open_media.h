// SPDX-License-Identifier: MIT
// Media that nothing encloses: fog around the camera, or before surfaces.
#pragma once

#include <optional>

#include "scene/model/scene.h"

namespace strahl {

/// The first element that puts a homogeneous medium where it may have no end, under an integrator that goes through
/// media; none where there is none. A medium has an end where one closed shape around it is full of it; every mesh
/// counts as closed.
[[nodiscard]] std::optional<SourceLocation> open_medium(const Scene& scene);

}  // namespace strahl
