// SPDX-License-Identifier: MIT
// Vertex splitting and stand-in normals.
#include "scene/meshes/mesh_builder.h"

#include <fmt/format.h>

#include <limits>
#include <utility>

#include "scene/meshes/triangulate.h"

namespace strahl {
MeshBuilder::MeshBuilder(const MeshAttributes& attributes, std::size_t triangles)
    : attributes_(attributes), first_vertex_(attributes.positions.size(), -1) {
  corner_of_vertex_.reserve(attributes.positions.size());
  next_vertex_.reserve(attributes.positions.size());
  mesh_.positions.reserve(attributes.positions.size());
  mesh_.triangles.reserve(triangles);
  mesh_.part_of_triangle.reserve(triangles);
}

int MeshBuilder::append(const MeshCorner& corner) {
  if (mesh_.positions.size() == static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw InputError("a mesh of more than 2147483647 vertices");
  }
  corner_of_vertex_.push_back(corner);
  next_vertex_.push_back(-1);
  mesh_.positions.push_back(attributes_.positions[static_cast<std::size_t>(corner.position)]);
  has_uvs_ |= corner.uv >= 0;
  has_normals_ |= corner.normal >= 0;
  return static_cast<int>(mesh_.positions.size()) - 1;
}

int MeshBuilder::vertex_of(const MeshCorner& corner) {
  int vertex = first_vertex_[static_cast<std::size_t>(corner.position)], last = -1;
  for (int length = 0; length < longest_list; ++length) {
    if (vertex < 0) {
      vertex = append(corner);
      (last < 0 ? first_vertex_[static_cast<std::size_t>(corner.position)]
                : next_vertex_[static_cast<std::size_t>(last)]) = vertex;
      return vertex;
    }
    if (corner_of_vertex_[static_cast<std::size_t>(vertex)] == corner) return vertex;
    last = vertex;
    vertex = next_vertex_[static_cast<std::size_t>(vertex)];
  }
  const auto [entry, is_new] = further_vertices_.try_emplace(corner, 0);
  if (is_new) entry->second = append(corner);
  return entry->second;
}

bool MeshBuilder::add_polygon(std::span<const MeshCorner> corners, int part) {
  polygon_.clear();
  for (const MeshCorner& c : corners) {
    polygon_.push_back(attributes_.positions[static_cast<std::size_t>(c.position)]);
  }
  pieces_.clear();
  if (!triangulate(polygon_, pieces_)) return false;
  for (const auto& piece : pieces_) {
    const auto vertex = [&](int i) { return vertex_of(corners[static_cast<std::size_t>(i)]); };
    const int v0 = vertex(piece[0]), v1 = vertex(piece[1]), v2 = vertex(piece[2]);
    mesh_.triangles.push_back({v0, v1, v2});
    mesh_.part_of_triangle.push_back(part);
  }
  return true;
}

void MeshBuilder::set_normals() {
  std::vector<char> missing;
  std::size_t absent = 0, zero = 0;
  missing.reserve(corner_of_vertex_.size());
  mesh_.normals.reserve(corner_of_vertex_.size());
  for (const MeshCorner& c : corner_of_vertex_) {
    const Vec3 n = c.normal < 0 ? Vec3{} : attributes_.normals[static_cast<std::size_t>(c.normal)];
    missing.push_back(n == Vec3{});
    if (missing.back()) ++(c.normal < 0 ? absent : zero);
    mesh_.normals.push_back(missing.back() ? n : normalized(n));
  }
  if (absent > 0) warnings_.push_back(fmt::format("{} vertices have no normal; their faces' stand in", absent));
  if (zero > 0) warnings_.push_back(fmt::format("{} vertices have a normal of length 0; their faces' stand in", zero));
  for (auto& triangle : mesh_.triangles) {
    for (int& vertex : triangle) {
      const auto v = static_cast<std::size_t>(vertex);
      if (v >= missing.size() || !missing[v]) continue;
      const auto& p = mesh_.positions;
      const Vec3 n = triangle_normal(p[static_cast<std::size_t>(triangle[0])], p[static_cast<std::size_t>(triangle[1])],
                                     p[static_cast<std::size_t>(triangle[2])]);
      if (mesh_.normals[v] == Vec3{}) mesh_.normals[v] = n;
      if (mesh_.normals[v] == n) continue;
      mesh_.positions.push_back(Vec3(p[v]));
      mesh_.normals.push_back(n);
      if (has_uvs_) mesh_.uvs.push_back(Vec2(mesh_.uvs[v]));
      for (MeshAttribute& attribute : mesh_.attributes) attribute.values.push_back(Rgb(attribute.values[v]));
      vertex = static_cast<int>(mesh_.positions.size()) - 1;
    }
  }
}

Mesh MeshBuilder::finish() {
  if (has_uvs_) {
    mesh_.uvs.reserve(corner_of_vertex_.size());
    for (const MeshCorner& c : corner_of_vertex_) {
      mesh_.uvs.push_back(c.uv < 0 ? Vec2{} : attributes_.uvs[static_cast<std::size_t>(c.uv)]);
    }
  }
  for (const MeshAttribute& from : attributes_.others) {
    MeshAttribute& attribute = mesh_.attributes.emplace_back(MeshAttribute{from.name, {}});
    attribute.values.reserve(corner_of_vertex_.size());
    for (const MeshCorner& c : corner_of_vertex_)
      attribute.values.push_back(from.values[static_cast<std::size_t>(c.position)]);
  }
  if (has_normals_) set_normals();
  return std::move(mesh_);
}

}  // namespace strahl
