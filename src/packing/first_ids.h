// SPDX-License-Identifier: MIT
// Numbers of primitives over the whole scene.
#pragma once

#include <cstdint>
#include <vector>

#include "scene/model/scene.h"

namespace strahl {

/// Scene-wide id of primitive 0 of every shape, those of groups after the scene's own, and one past the last.
[[nodiscard]] std::vector<std::int64_t> first_ids(const Scene& scene);

}  // namespace strahl
