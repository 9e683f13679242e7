// SPDX-License-Identifier: MIT
// What must hold for a Scene before anything is computed from it.
#pragma once

#include <vector>

#include "scene/model/scene.h"

namespace strahl {

/// Every violation of the invariants stated in scene.h (finite numbers, radius > 0, min <= max, indices in range,
/// material and mesh indices valid, sizes within [1, 65536], ...). Empty: the scene can be rendered.
[[nodiscard]] std::vector<Diagnostic> validate(const Scene& scene);

/// The part of it that looks at no shape, material, texture, light or medium: camera, film, sampler, integrator.
[[nodiscard]] std::vector<Diagnostic> validate_picture(const Scene& scene);

}  // namespace strahl
