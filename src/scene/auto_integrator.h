// SPDX-License-Identifier: MIT
// Integrator "auto": the cheapest one whose picture has the same expectation as that of "path".
#pragma once

#include "scene/model/scene.h"

namespace strahl {

/// Sets scene.integrator.name, to "emission", "direct", "path" or, where there are media, "volpath", and why. It
/// depends on the scene alone: its shapes, materials and the integrator's max_depth.
void choose_integrator(Scene& scene);

/// Makes volpath what it is without media, masks and panes of thin glass: path.
void simplify_integrator(Scene& scene);

}  // namespace strahl
