// SPDX-License-Identifier: MIT
// Polygons with an index per attribute (OBJ's way) to triangles over shared vertices (Mesh's way).
//
// A position that is used with several normals or texture coordinates becomes several vertices; what no triangle uses
// is left out. Normals become unit vectors; where some are missing or zero, the triangle's own stands in. Missing
// texture coordinates are (0, 0).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "scene/model/scene.h"

namespace strahl {

/// One corner of a polygon; -1 where it has no texture coordinate or normal.
struct MeshCorner {
  int position = 0, uv = -1, normal = -1;
  friend bool operator==(const MeshCorner&, const MeshCorner&) = default;
};

/// What a file says about points in space; a corner's indices point into it.
struct MeshAttributes {
  std::vector<Vec3> positions;
  std::vector<Vec2> uvs;
  std::vector<Vec3> normals;
  std::vector<MeshAttribute> others;  ///< Of vertices: a value for each position.
};

class MeshBuilder {
 public:
  /// `attributes` must live as long as the builder.
  /// `triangles`: how many are expected, so that memory is taken once.
  MeshBuilder(const MeshAttributes& attributes, std::size_t triangles);

  /// False where the polygon is degenerate or crosses itself: nothing is added. `part` goes to part_of_triangle.
  [[nodiscard]] bool add_polygon(std::span<const MeshCorner> corners, int part);
  [[nodiscard]] std::size_t triangle_count() const { return mesh_.triangles.size(); }
  /// part_of_triangle is as long as triangles. Leaves the builder empty.
  [[nodiscard]] Mesh finish();
  /// What stood in for something missing, after finish().
  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  struct CornerHash {
    std::size_t operator()(const MeshCorner& c) const {
      std::size_t h = static_cast<std::size_t>(c.position) * 0x9e3779b97f4a7c15u;
      h = (h ^ (h >> 29) ^ static_cast<std::size_t>(c.uv)) * 0xbf58476d1ce4e5b9u;
      return (h ^ (h >> 32) ^ static_cast<std::size_t>(c.normal)) * 0x94d049bb133111ebu;
    }
  };

  int vertex_of(const MeshCorner& corner);
  int append(const MeshCorner& corner);
  void set_normals();

  const MeshAttributes& attributes_;
  Mesh mesh_;
  // The vertices of a position are a list, which most corners find at once; those of one where hundreds of faces meet
  // (a cone's apex) go on in a map.
  static constexpr int longest_list = 16;
  std::vector<MeshCorner> corner_of_vertex_;
  std::vector<int> first_vertex_;  // of each position, -1: none
  std::vector<int> next_vertex_;   // of each vertex, -1: none
  std::unordered_map<MeshCorner, int, CornerHash> further_vertices_;
  std::vector<Vec3> polygon_;
  std::vector<std::array<int, 3>> pieces_;
  std::vector<std::string> warnings_;
  bool has_uvs_ = false, has_normals_ = false;
};

}  // namespace strahl
