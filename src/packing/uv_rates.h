// SPDX-License-Identifier: MIT
// How fast texture coordinates change over a shape.
#pragma once

#include "kinds/upload_frame.h"
#include "scene/model/scene.h"

namespace strahl {

/// Change of u and v per unit of length of the frame where it is least: at the equator of a sphere, the rim of a disk,
/// the triangle of a mesh that is stretched least. So the filters of textures, which take one size for the whole shape,
/// never blur more than they should; where they filter too little, samples do.
[[nodiscard]] Vec2 uv_rates(const Geometry& geometry, const UploadFrame& frame);

}  // namespace strahl
