// SPDX-License-Identifier: MIT
#include "study/generated/scenes.h"
#include "study/generated/stage.h"

namespace strahl {

Scene box_lattice(int n) {
  Scene scene = stage("lattice-" + std::to_string(n), {1.7, 1.3, 1.9}, {}, {0, 1, 0}, 40, {3, 5, 2});
  const double pitch = 1.0 / n;
  for (int z = 0; z < n; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        const Vec3 low{x * pitch - 0.5, y * pitch - 0.5, z * pitch - 0.5};
        const double side = 0.6 * pitch;
        scene.shapes.emplace_back().geometry = Box{to_float(low), to_float(low + Vec3{side, side, side})};
      }
  return scene;
}

}  // namespace strahl
