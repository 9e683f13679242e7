// SPDX-License-Identifier: MIT
// What paths that begin on lights cannot do with a scene.
#pragma once

#include <optional>
#include <string>

#include "errors.h"
#include "scene/model/scene.h"

namespace strahl {

/// Why `integrator`, one of those whose paths begin on lights, refuses the scene, whatever the sampler, the filter and
/// the options; none where it renders it.
[[nodiscard]] std::optional<Diagnostic> light_path_fault(const Scene& scene, const std::string& integrator);

/// Whether it renders the scene with the scene's own sampler.
[[nodiscard]] bool takes_light_paths(const Scene& scene, const std::string& integrator);

}  // namespace strahl
