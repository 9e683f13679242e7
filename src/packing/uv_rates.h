// SPDX-License-Identifier: MIT
// How fast texture coordinates change over a shape.
#pragma once

#include "kinds/upload_frame.h"
#include "scene/model/scene.h"

namespace strahl {

/// Change of u and v per unit of length of the frame: the largest of a flat shape or a quadric's own parameters away
/// from where they are singular (the equator of a sphere, the rim of a disk), the mean over a mesh that has uvs. For
/// the filters of textures, which need a size, not the exact map.
[[nodiscard]] Vec2 uv_rates(const Geometry& geometry, const UploadFrame& frame);

}  // namespace strahl
