// SPDX-License-Identifier: MIT
// The numeric error of the hits of a picture's first samples. Each ray, exactly as it was traced, is intersected with
// the scene again in double precision, in world coordinates and with no number rounded to float.
#pragma once

#include <cstdint>
#include <vector>

#include "kinds/upload_frame.h"
#include "opencl/device.h"
#include "packing/memory_estimate.h"
#include "scene/model/scene.h"
#include "settings/settings.h"

namespace strahl {

/// Throws NoDeviceError where the device has no fp64, or no room for the scene in double precision beside `picture`,
/// what that of the picture takes at the least.
void require_numeric_error(const Device& device, const Scene& scene, const RenderSettings& of_picture,
                           const MemoryNeed& picture);

/// reals, ints: as aov_image (aov.h) takes them. Every AOV_T becomes |t - t in double| in ulps of float of the latter:
/// infinity where one of the two is a hit and the other none, 0 where neither is. The device must have fp64.
/// of_picture: the settings of the picture; the disabled effects and the loop limit hold here too.
void replace_t_by_its_error(const Device& device, const Scene& scene, const UploadFrame& frame,
                            const RenderSettings& of_picture, std::vector<double>& reals,
                            const std::vector<std::int32_t>& ints);

}  // namespace strahl
