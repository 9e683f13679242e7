// SPDX-License-Identifier: MIT
// The table of lights (cl/scene/layout.h, LIGHT_...), and what the header says of it.
#pragma once

#include <cstdint>
#include <vector>

#include "kinds/upload_frame.h"
#include "packing/pack_images.h"
#include "packing/packed_scene.h"
#include "program/features.h"
#include "scene/model/scene.h"

namespace strahl {

/// images: of environments. shapes, first_ids: as for_each_shape has them. Returns the row of each part of the scene;
/// -1: no light that could be drawn.
template <typename Real>
[[nodiscard]] std::vector<int> pack_lights(PackedScene<Real>& packed, PackedImages<Real>& images, const Scene& scene,
                                           const Features& features, const UploadFrame& frame,
                                           const std::vector<const Shape*>& shapes,
                                           const std::vector<std::int32_t>& first_ids);

}  // namespace strahl
