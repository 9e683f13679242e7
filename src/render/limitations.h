// SPDX-License-Identifier: MIT
// What a scene calls for that its integrator cannot do yet, and a picture that will be empty: said, never left out in
// silence.
#pragma once

#include <vector>

#include "scene/model/scene.h"

namespace strahl {

/// Warnings in scene order; empty where the picture will show all that the scene asks for.
[[nodiscard]] std::vector<Diagnostic> limitations(const Scene& scene);

}  // namespace strahl
