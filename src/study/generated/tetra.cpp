// SPDX-License-Identifier: MIT
// SPD's tetra.c: corners of a cube of side 2, the faces of the smallest tetrahedra only.
#include <array>
#include <cmath>

#include "study/generated/scenes.h"
#include "study/generated/stage.h"

namespace strahl {
namespace {

constexpr std::array<Vec3, 4> corners{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};

void grow(int depth, const Vec3& center, double size, Mesh& mesh) {
  if (depth > 1) {
    for (const Vec3& corner : corners) grow(depth - 1, center + (size / 2) * corner, size / 2, mesh);
    return;
  }
  const int first = static_cast<int>(mesh.positions.size());
  for (const Vec3& corner : corners) mesh.positions.push_back(center + size * corner);
  for (const auto& [a, b, c] : {std::array{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}})
    mesh.triangles.push_back({first + a, first + b, first + c});
}

}  // namespace

Scene tetra(int depth) {
  Scene scene = stage("tetra-" + std::to_string(depth), {1.02285, -3.17715, -2.17451}, {-0.004103, -0.004103, 0.216539},
                      {-0.816497, -0.816497, 0.816497}, 45, {2, -18, -5});
  Mesh mesh;
  grow(depth, {}, 1, mesh);
  scene.shapes.emplace_back().geometry = std::move(mesh);
  return scene;
}

}  // namespace strahl
