// SPDX-License-Identifier: MIT
#include "scene/meshes/vertex_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

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
  const auto agreement = [&](const std::array<int, 3>& triangle) {
    Vec3 sum;
    for (const int vertex : triangle) sum = sum + mesh.normals[static_cast<std::size_t>(vertex)];
    return dot(across(mesh, triangle), sum);
  };
  const auto averted = std::ranges::count_if(
      mesh.triangles, [](double a) { return a < 0; }, agreement);
  const auto agreeing = std::ranges::count_if(
      mesh.triangles, [](double a) { return a > 0; }, agreement);
  const bool is_turned = averted > agreeing;
  if (is_turned)
    for (Vec3& normal : mesh.normals) normal = -normal;
  for (std::array<int, 3>& triangle : mesh.triangles)
    if (agreement(triangle) < 0) std::swap(triangle[1], triangle[2]);
  return is_turned;
}

}  // namespace strahl
