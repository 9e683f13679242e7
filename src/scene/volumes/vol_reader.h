// SPDX-License-Identifier: MIT
// Grids in Mitsuba's binary format, .vol version 3: "VOL", a byte 3, then little-endian int32 1 (floats) or 3 (bytes,
// 255 of which is 1), width, height, depth, channels, six float32 of the box (low x y z, high x y z), and the texels, x
// first, then y, then z.
#pragma once

#include <string>

#include "scene/model/volume.h"

namespace strahl {

/// Throws InputError that names the file.
[[nodiscard]] VolumeGrid read_vol(const std::string& path);

}  // namespace strahl
