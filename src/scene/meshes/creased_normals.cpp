// SPDX-License-Identifier: MIT
#include "scene/meshes/creased_normals.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "scene/meshes/vertex_normals.h"

namespace strahl {

namespace {

using Corner = std::pair<std::size_t, std::size_t>;  ///< Triangle, and which of its three.

std::vector<Vec3> normals_of_faces(const Mesh& mesh) {
  std::vector<Vec3> normals;
  normals.reserve(mesh.triangles.size());
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    const auto corner = [&](std::size_t i) { return mesh.positions[static_cast<std::size_t>(triangle.at(i))]; };
    const Vec3 across = cross(corner(1) - corner(0), corner(2) - corner(0));
    normals.push_back(across == Vec3{} ? across : normalized(across));
  }
  return normals;
}

/// The corners that are one vertex, in the order of the triangles.
std::vector<std::vector<Corner>> corners_by_place(const Mesh& mesh) {
  std::map<std::array<double, 5>, std::size_t> places;
  std::vector<std::vector<Corner>> corners;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto vertex = static_cast<std::size_t>(mesh.triangles[t].at(i));
      const Vec3& p = mesh.positions[vertex];
      const Vec2 uv = mesh.uvs.empty() ? Vec2{} : mesh.uvs[vertex];
      const auto [place, is_new] = places.try_emplace({p.x, p.y, p.z, uv.x, uv.y}, corners.size());
      if (is_new) corners.emplace_back();
      corners[place->second].emplace_back(t, i);
    }
  return corners;
}

}  // namespace

void make_creased_normals(Mesh& mesh, double degrees) {
  const std::vector<Vec3> normals = normals_of_faces(mesh);
  const double least = std::cos(degrees * std::numbers::pi / 180);
  std::vector<std::array<int, 3>> triangles = mesh.triangles;
  std::vector<std::size_t> from;  ///< The vertex that each new one was.
  for (std::vector<Corner>& left : corners_by_place(mesh)) {
    while (!left.empty()) {
      const Corner first = left.front();
      from.push_back(static_cast<std::size_t>(mesh.triangles[first.first].at(first.second)));
      std::vector<Corner> others;
      for (const Corner& corner : left) {
        const bool is_smooth = corner.first == first.first || dot(normals[first.first], normals[corner.first]) >= least;
        if (is_smooth)
          triangles[corner.first].at(corner.second) = static_cast<int>(from.size()) - 1;
        else
          others.push_back(corner);
      }
      left = std::move(others);
    }
  }
  const auto taken = [&](const auto& values) {
    std::decay_t<decltype(values)> kept;
    if (values.empty()) return kept;
    kept.reserve(from.size());
    for (const std::size_t vertex : from) kept.push_back(values[vertex]);
    return kept;
  };
  mesh.positions = taken(mesh.positions);
  mesh.uvs = taken(mesh.uvs);
  for (MeshAttribute& attribute : mesh.attributes)
    if (!attribute.is_of_faces()) attribute.values = taken(attribute.values);
  mesh.triangles = std::move(triangles);
  make_vertex_normals(mesh);
}

}  // namespace strahl
