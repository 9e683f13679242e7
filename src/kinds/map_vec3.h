// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "scene/model/vec.h"

namespace strahl {

/// Maps a position, an edge or a direction when a scene is moved, scaled or mirrored.
using MapVec3 = std::function<Vec3(const Vec3&)>;

}  // namespace strahl
