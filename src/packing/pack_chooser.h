// SPDX-License-Identifier: MIT
// How a point chooses one of the lights that are drawn (cl/choosers).
#pragma once

#include <span>

#include "kinds/light_reach.h"
#include "kinds/upload_frame.h"
#include "packing/packed_scene.h"
#include "program/features.h"
#include "scene/model/scene.h"

namespace strahl {

/// HEADER_CHOOSER and what it reads. lights: those that are drawn, in the table's order.
template <typename Real>
void pack_chooser(PackedScene<Real>& packed, const Scene& scene, const Features& features, const UploadFrame& frame,
                  std::span<const LightReach> lights);

}  // namespace strahl
