// SPDX-License-Identifier: MIT
// First-sample values of every pixel as named channels.
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "image/image.h"
#include "kinds/upload_frame.h"
#include "settings/settings.h"

namespace strahl {

/// "depth.Z", "normal.X" "normal.Y" "normal.Z", "position.X" ..., "uv.U" "uv.V", "shape_id.I", "primitive_id.I",
/// "numeric_error.ULP".
[[nodiscard]] std::vector<std::string> aov_channels(const std::set<Aov>& aovs);

/// Raw values as cl/scene/layout.h orders them (AOV_REALS and AOV_INTS a pixel); positions and depths return to the
/// world frame. With numeric_error, t has given way to its error (numeric_error.h).
[[nodiscard]] Image aov_image(int width, int height, const std::set<Aov>& aovs, const std::vector<double>& reals,
                              const std::vector<std::int32_t>& ints, const UploadFrame& frame);

}  // namespace strahl
