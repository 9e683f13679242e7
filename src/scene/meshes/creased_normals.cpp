// SPDX-License-Identifier: MIT
#include "scene/meshes/creased_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
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

/// Orders vertices by what tells them apart, in which 0 and -0 are alike. Attributes need not be finite.
class VertexOrder {
 public:
  explicit VertexOrder(const Mesh& mesh) : mesh_(mesh) {}

  bool operator()(std::size_t a, std::size_t b) const {
    const auto value = [](const auto& values, std::size_t vertex) { return numbers_of(values[vertex]); };
    const auto order_by = [&](const auto& values) { return order_of(value(values, a), value(values, b)); };
    std::weak_ordering order = order_by(mesh_.positions);
    if (std::is_eq(order) && !mesh_.uvs.empty()) order = order_by(mesh_.uvs);
    for (const MeshAttribute& attribute : mesh_.attributes)
      if (std::is_eq(order) && !attribute.is_of_faces()) order = order_by(attribute.values);
    return std::is_lt(order);
  }

 private:
  using Numbers = std::array<double, 3>;
  static Numbers numbers_of(const Vec3& v) { return {v.x, v.y, v.z}; }
  static Numbers numbers_of(const Vec2& v) { return {v.x, v.y, 0}; }
  static Numbers numbers_of(const Rgb& c) { return {c.r, c.g, c.b}; }
  static std::weak_ordering order_of(const Numbers& a, const Numbers& b) {
    for (std::size_t i = 0; i < a.size(); ++i)
      if (const std::weak_ordering order = std::weak_order(a.at(i), b.at(i)); std::is_neq(order)) return order;
    return std::weak_ordering::equivalent;
  }

  const Mesh& mesh_;
};

/// The corners that are one vertex, in the order of the triangles.
std::vector<std::vector<Corner>> corners_by_place(const Mesh& mesh) {
  std::map<std::size_t, std::size_t, VertexOrder> places{VertexOrder(mesh)};
  std::vector<std::vector<Corner>> corners;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto vertex = static_cast<std::size_t>(mesh.triangles[t].at(i));
      const auto [place, is_new] = places.try_emplace(vertex, corners.size());
      if (is_new) corners.emplace_back();
      corners[place->second].emplace_back(t, i);
    }
  return corners;
}

/// The groups at a place, each a new vertex, told by the normal of its first corner.
class Groups {
 public:
  /// least: the cosine between normals of one group.
  explicit Groups(double least)
      : least_(least), reach_(1.01 * std::sqrt(std::max(0.0, 2 - 2 * least) + rounding_of_squares)) {}

  /// The first with a normal near this one; none: -1.
  [[nodiscard]] int find(const Vec3& normal) const {
    int first = -1;
    const auto look_at = [&](const Group& group) {
      if ((first < 0 || group.vertex < first) && dot(group.normal, normal) >= least_) first = group.vertex;
    };
    std::ranges::for_each(few_, look_at);
    if (first >= 0 || cells_.empty() || !is_direction(normal)) return first;
    const Cell low = cell_of(normal - reach_ * Vec3{1, 1, 1}), high = cell_of(normal + reach_ * Vec3{1, 1, 1});
    for (std::int64_t x = low[0]; x <= high[0]; ++x)
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
        for (std::int64_t z = low[2]; z <= high[2]; ++z)
          if (const auto cell = cells_.find({x, y, z}); cell != cells_.end())
            std::ranges::for_each(cell->second, look_at);
    return first;
  }

  /// One that find did not find, of a greater vertex than all before.
  void add(const Vec3& normal, int vertex) {
    if (few_.size() < most_of_few) return few_.push_back({normal, vertex});
    if (!is_direction(normal)) return;  // Without an area: near to none.
    std::vector<Group>& cell = cells_[cell_of(normal)];
    // Rounded, a normal may not be near itself.
    if (std::ranges::find(cell, normal, &Group::normal) == cell.end()) cell.push_back({normal, vertex});
  }

 private:
  struct Group {
    Vec3 normal;
    int vertex;
  };
  using Cell = std::array<std::int64_t, 3>;

  static constexpr std::size_t most_of_few = 64;
  /// Bounds what the squares of lengths of unit vectors and twice their dot product are off by.
  static constexpr double rounding_of_squares = 16 * 0x1p-53;

  static bool is_direction(const Vec3& normal) { return dot(normal, normal) > 0.5; }
  [[nodiscard]] Cell cell_of(const Vec3& p) const {
    const auto place = [&](double x) { return static_cast<std::int64_t>(std::floor(x / (4 * reach_))); };
    return {place(p.x), place(p.y), place(p.z)};
  }

  double least_, reach_;  ///< reach_: beyond this distance no normals are near.
  std::vector<Group> few_;
  std::map<Cell, std::vector<Group>> cells_;  ///< Those after the few.
};

}  // namespace

void make_creased_normals(Mesh& mesh, double degrees) {
  const std::vector<Vec3> normals = normals_of_faces(mesh);
  const double least = std::cos(degrees * std::numbers::pi / 180);
  std::vector<std::array<int, 3>> triangles = mesh.triangles;
  std::vector<std::size_t> from;  ///< The vertex that each new one was.
  for (const std::vector<Corner>& corners : corners_by_place(mesh)) {
    Groups groups(least);
    std::size_t last = mesh.triangles.size();
    int vertex = -1;
    for (const auto& [triangle, corner] : corners) {
      if (triangle != last) vertex = groups.find(normals[triangle]);  // All of a triangle's corners here are alike.
      if (vertex < 0) {
        vertex = static_cast<int>(from.size());
        from.push_back(static_cast<std::size_t>(mesh.triangles[triangle].at(corner)));
        groups.add(normals[triangle], vertex);
      }
      triangles[triangle].at(corner) = vertex;
      last = triangle;
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
