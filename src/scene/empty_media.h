// SPDX-License-Identifier: MIT
// Media of nothing: grids without smoke, a sigma_t of 0.
#pragma once

#include "scene/model/scene.h"

namespace strahl {

/// Leaves out what no path of the scene can notice: where all media are empty there are none, and surfaces that let
/// all light pass are not met. No picture changes but for its noise, so this is not for scenes of which other values
/// are asked, nor for integrators to which such surfaces count as depth. Shapes are numbered anew.
void leave_out_empty_media(Scene& scene);

}  // namespace strahl
