// SPDX-License-Identifier: MIT
// What the floats of a tier add to a picture's error, told by rendering it small twice, with the same samples: in the
// tier, and in double precision.
#pragma once

#include <optional>

#include "device/device.h"
#include "render/settings.h"
#include "scene/scene.h"

namespace strahl {

/// RMSE over linear RGB that rounding adds to a picture of `spp` samples a pixel. Differences that stay the same from
/// seed to seed count whole, those that samples average out count as `spp` of them would. None where the device has no
/// double precision, the tier is double already, or the scene is too large to be uploaded once more.
[[nodiscard]] std::optional<double> rounding_rmse(const Device& device, const Scene& scene,
                                                  const RenderSettings& settings, int spp, std::uint64_t scene_bytes);

}  // namespace strahl
