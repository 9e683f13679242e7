// SPDX-License-Identifier: MIT
// What the generated scenes have in common: camera, film, one lamp, coordinates that a float holds.
#pragma once

#include "scene/model/scene.h"

namespace strahl {

/// Rounded to the nearest float.
[[nodiscard]] Vec3 to_float(const Vec3& v);

/// A square picture of 1024 pixels, one ray through the middle of each, direct light of one lamp that lights what is as
/// far from it as `target` with radiance 1/2.
[[nodiscard]] Scene stage(const std::string& name, const Vec3& camera, const Vec3& target, const Vec3& up,
                          double fov_degrees, const Vec3& lamp);

}  // namespace strahl
