// SPDX-License-Identifier: MIT
#include "scene/meshes/vertex_normals.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace strahl {

namespace {

/// Between two vectors, 0 to pi; with all its digits near both ends.
double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(length(cross(a, b)), dot(a, b)); }

/// Twice the triangle's area along its normal.
Vec3 across(const Mesh& mesh, const std::array<int, 3>& triangle) {
  const auto position = [&](int vertex) { return mesh.positions[static_cast<std::size_t>(vertex)]; };
  return cross(position(triangle[1]) - position(triangle[0]), position(triangle[2]) - position(triangle[0]));
}

}  // namespace

void make_vertex_normals(Mesh& mesh) {
  mesh.normals.assign(mesh.positions.size(), Vec3{});
  const auto position = [&](int vertex) { return mesh.positions[static_cast<std::size_t>(vertex)]; };
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    const Vec3 along = across(mesh, triangle);
    if (along == Vec3{}) continue;
    const Vec3 normal = normalized(along);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 corner = position(triangle.at(i));
      const double angle =
          angle_between(position(triangle.at((i + 1) % 3)) - corner, position(triangle.at((i + 2) % 3)) - corner);
      Vec3& sum = mesh.normals[static_cast<std::size_t>(triangle.at(i))];
      sum = sum + angle * normal;
    }
  }
  for (Vec3& normal : mesh.normals) normal = normal == Vec3{} ? Vec3{1, 0, 0} : normalized(normal);
}

bool turn_to_vertex_normals(Mesh& mesh) {
  std::vector<std::size_t> averted, agreeing;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::array<int, 3>& triangle = mesh.triangles[i];
    Vec3 sum;
    for (const int vertex : triangle) sum = sum + mesh.normals[static_cast<std::size_t>(vertex)];
    const double agreement = dot(across(mesh, triangle), sum);
    if (agreement != 0) (agreement < 0 ? averted : agreeing).push_back(i);
  }
  const bool is_turned = averted.size() > agreeing.size();
  if (is_turned)
    for (Vec3& normal : mesh.normals) normal = -normal;
  for (const std::size_t i : is_turned ? agreeing : averted) std::swap(mesh.triangles[i][1], mesh.triangles[i][2]);
  return is_turned;
}

}  // namespace strahl
