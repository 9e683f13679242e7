// SPDX-License-Identifier: MIT
// How far off the hits of a picture's first samples are: each ray, exactly as it was traced, meets the scene once more
// in double precision, in the world's coordinates and with none of its numbers rounded to float.
#pragma once

#include <cstdint>
#include <vector>

#include "kinds/upload_frame.h"
#include "opencl/device.h"
#include "scene/model/scene.h"
#include "settings/settings.h"

namespace strahl {

/// reals, ints: as aov_image (aov.h) takes them. Every AOV_T becomes |t - t in double| in ulps of float of the latter:
/// infinity where one of the two is a hit and the other none, 0 where neither is. The device must have fp64.
/// of_picture: how it was rendered, of which what is disabled and the loops' end hold here too.
void replace_t_by_its_error(const Device& device, const Scene& scene, const UploadFrame& frame,
                            const RenderSettings& of_picture, std::vector<double>& reals,
                            const std::vector<std::int32_t>& ints);

}  // namespace strahl
