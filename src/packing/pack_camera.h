// SPDX-License-Identifier: MIT
// The camera as the affine map of cl/camera/camera_lanes.h.
#pragma once

#include <vector>

#include "kinds/upload_frame.h"

namespace strahl {

/// CAMERA_REALS values. Picture coordinates run from -1 to 1, x to the right and y down, over the whole film.
[[nodiscard]] std::vector<double> camera_reals(const Camera& camera, const Film& film, const UploadFrame& frame);
/// Of the scene's. A sample at a pixel's centre goes through the lens's middle, though the program may have a lens.
[[nodiscard]] std::vector<double> camera_reals(const Scene& scene, SamplerKind sampler, const UploadFrame& frame);

/// SENSOR_REALS values and the filter's table: the same map the other way round (cl/camera/projection_lanes.h).
[[nodiscard]] std::vector<double> sensor_reals(const Camera& camera, const Film& film, const UploadFrame& frame);

}  // namespace strahl
