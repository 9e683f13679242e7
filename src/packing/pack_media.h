// SPDX-License-Identifier: MIT
// Media in the buffers of cl/media/media_layout.h.
#pragma once

#include <vector>

#include "kinds/upload_frame.h"
#include "packing/pack_images.h"
#include "packing/packed_scene.h"
#include "program/features.h"
#include "scene/model/scene.h"

namespace strahl {

/// Whether a shape is seen by nothing, in a program with MEDIA whose paths go through media: rays meet it apart from
/// all else (cl/media/boundaries_lanes.h). Not of groups.
[[nodiscard]] bool stands_apart_as_boundary(const Shape& shape, const Scene& scene, const Features& features);

/// Fills the row of media at `row` and what it points to. boundaries: of every part; none: it is no boundary. Under an
/// integrator that ignores media there are none.
template <typename Real>
void pack_media(PackedScene<Real>& packed, PackedImages<Real>& images, int row, const Scene& scene,
                const Features& features, const UploadFrame& frame,
                const std::vector<std::optional<MediumBoundary>>& boundaries);

}  // namespace strahl
