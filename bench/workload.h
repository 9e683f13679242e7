// SPDX-License-Identifier: MIT
// What is timed: rays through a scene, and the answer that the time is worth nothing without.
#pragma once

#include <string>
#include <vector>

#include "render/intersector.h"
#include "scene/model/scene.h"

namespace strahl::bench {

struct Workload {
  std::string name;
  Scene scene;
  std::vector<Ray> rays;
  std::vector<bool> hits;  ///< A ray each: something is met. From the oracle.
};

}  // namespace strahl::bench
