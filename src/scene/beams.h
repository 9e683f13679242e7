// SPDX-License-Identifier: MIT
// Beams: lights whose places shine in one direction each (emitters collimated and directionalarea), so that neither a
// ray from the camera nor one from a surface finds them, but a path that begins there.
#pragma once

#include <vector>

#include "scene/model/scene.h"

namespace strahl {

/// Of each that gives light its emitter, in the scene's order, lights outside shapes first.
[[nodiscard]] std::vector<SourceLocation> beams_of(const Scene& scene);

/// Whether there is light, and all of it in beams. Media count as light where they emit.
[[nodiscard]] bool has_beams_alone(const Scene& scene);

}  // namespace strahl
