// SPDX-License-Identifier: MIT
#include "study/generated/scenes.h"
#include "study/generated/stage.h"

namespace strahl {

Scene ten_spheres() {
  Scene scene = stage("ten", {0, 3.5, 8}, {0, 0.5, 0}, {0, 1, 0}, 40, {4, 7, 5});
  scene.shapes.emplace_back().geometry = Plane{};
  for (int i = 0; i < 10; ++i) {
    const int column = i % 4, row = i / 4;
    const double x = 1.5 * column - 2.25, z = 1.75 * row - 2.25, radius = 0.375 + 0.03125 * (i % 5);
    scene.shapes.emplace_back().geometry = Sphere{{x, radius, z}, radius};
  }
  return scene;
}

}  // namespace strahl
