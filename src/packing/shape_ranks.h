// SPDX-License-Identifier: MIT
// Which of several overlapping shapes is there.
#pragma once

#include <map>
#include <vector>

#include "scene/model/scene.h"

namespace strahl {

/// Places of the shapes that have a priority, in its order: of two alike the later shape comes first.
[[nodiscard]] std::map<const Shape*, int> shape_ranks(const std::vector<const Shape*>& shapes);

}  // namespace strahl
