// SPDX-License-Identifier: MIT
// Warnings about features of a scene that its integrator does not support yet, and about a picture that will be empty.
#pragma once

#include <vector>

#include "scene/model/scene.h"

namespace strahl {

/// Warnings in scene order; empty where the picture will show all that the scene asks for.
[[nodiscard]] std::vector<Diagnostic> limitations(const Scene& scene);

}  // namespace strahl
