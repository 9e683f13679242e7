// SPDX-License-Identifier: MIT
// Closed surfaces seen from within, and rays from within aimed at their shared edges and vertices.
#pragma once

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "oracle/random.h"
#include "render/intersector.h"
#include "scene/model/scene.h"
#include "selftest/to_float.h"

namespace strahl::selftest {

struct ClosedSurface {
  Scene scene;
  Vec3 center;
  double inner_radius = 0;  ///< All of that ball is inside, and sees every point of the surface.
  std::vector<Vec3> vertices;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
};

inline ClosedSurface surface_of(Geometry geometry, const Vec3& center, double inner_radius,
                                std::vector<Vec3> vertices) {
  ClosedSurface surface{{}, center, inner_radius, std::move(vertices), {}};
  surface.scene.materials.emplace_back();
  surface.scene.shapes.emplace_back().geometry = std::move(geometry);
  return surface;
}

/// 20 * 4^levels triangles, vertices rounded to float.
inline ClosedSurface icosphere(const Vec3& center, double radius, int levels) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  std::vector<Vec3> unit = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                            {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  std::vector<std::array<int, 3>> triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                               {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                               {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                               {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> midpoints;
    const auto middle = [&](int a, int b) {
      const auto [at, is_new] = midpoints.try_emplace(std::minmax(a, b), static_cast<int>(unit.size()));
      if (is_new)
        unit.push_back(0.5 *
                       (normalized(unit[static_cast<std::size_t>(a)]) + normalized(unit[static_cast<std::size_t>(b)])));
      return at->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    triangles = finer;
  }
  Mesh mesh;
  for (const Vec3& v : unit) mesh.positions.push_back(to_float(center + radius * normalized(v)));
  mesh.triangles = triangles;
  ClosedSurface surface = surface_of(mesh, center, 0.5 * radius, mesh.positions);
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i)
      if (t[i] < t[(i + 1) % 3])
        surface.edges.emplace_back(static_cast<std::size_t>(t[i]), static_cast<std::size_t>(t[(i + 1) % 3]));
  return surface;
}

/// Six parallelograms; corners as the packer computes them, rounded to float.
inline ClosedSurface room(const Cube& cube) {
  std::vector<Vec3> corners;
  for (unsigned i = 0; i < 8; ++i) {
    Vec3 p = cube.corner;
    for (unsigned axis = 0; axis < 3; ++axis)
      if ((i >> axis) & 1u) p = p + cube.edge[axis];
    corners.push_back(to_float(p));
  }
  const Vec3 center = 0.5 * (corners[0] + corners[7]);
  double inner = INFINITY;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Vec3 n = normalized(cross(cube.edge[(axis + 1) % 3], cube.edge[(axis + 2) % 3]));
    inner = std::fmin(inner, 0.5 * std::fabs(dot(n, cube.edge[axis])));
  }
  ClosedSurface surface = surface_of(cube, center, 0.5 * inner, corners);
  for (unsigned i = 0; i < 8; ++i)
    for (unsigned axis = 0; axis < 3; ++axis)
      if (!((i >> axis) & 1u)) surface.edges.emplace_back(i, i | (1u << axis));
  return surface;
}

/// The same room as twelve triangles of one mesh.
inline ClosedSurface triangulated(const ClosedSurface& from) {
  constexpr std::array<std::array<int, 4>, 6> faces{
      {{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}}};
  Mesh mesh;
  mesh.positions = from.vertices;
  for (const auto& [a, b, c, d] : faces) mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
  ClosedSurface surface = surface_of(mesh, from.center, from.inner_radius, from.vertices);
  surface.edges = from.edges;
  for (const auto& face : faces)
    surface.edges.emplace_back(static_cast<std::size_t>(face[0]), static_cast<std::size_t>(face[2]));
  return surface;
}

/// Rooms and icospheres at ordinary and tiny size and far away, each with a name.
inline std::vector<std::pair<std::string, ClosedSurface>> closed_surfaces() {
  const Vec3 far_away{1e6, -1e6, 1e6};
  const ClosedSurface axes = room({{-3, -2, -5}, {{{8, 0, 0}, {0, 4, 0}, {0, 0, 6}}}});
  const ClosedSurface sheared = room({{0.1, 0.2, 0.3}, {{{1, 0.3, -0.2}, {0.1, 1.3, 0.25}, {-0.3, 0.2, 0.9}}}});
  const ClosedSurface far_room = room({far_away, {{{100.7, 0.3, 0.2}, {1.1, 60.3, 0.2}, {-0.3, 0.2, 80.1}}}});
  return {{"icosphere", icosphere({0, 0, 0}, 2, 2)},
          {"icosphere, 10^6 away", icosphere(far_away, 100, 2)},
          {"tiny icosphere", icosphere({0, 0, 0}, 1e-6, 1)},
          {"room along the axes", axes},
          {"its triangles", triangulated(axes)},
          {"sheared room", sheared},
          {"its triangles", triangulated(sheared)},
          {"room 10^6 away", far_room},
          {"its triangles", triangulated(far_room)}};
}

/// A third at vertices, a third at points of edges, a third along an axis through a vertex wherever the start is
/// inside.
inline std::vector<Ray> rays_at_seams(const ClosedSurface& surface, std::size_t count, std::uint64_t seed) {
  oracle::Random random(seed);
  const auto component = [&] { return random.uniform(-1, 1) * surface.inner_radius / std::sqrt(3.0); };
  std::vector<Ray> rays(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3& vertex = surface.vertices[random.bits() % surface.vertices.size()];
    const auto& [a, b] = surface.edges[random.bits() % surface.edges.size()];
    const double share = i % 2 ? random.uniform() : random.integer(0, 8) / 8.0;
    const Vec3 on_edge = surface.vertices[a] + share * (surface.vertices[b] - surface.vertices[a]);
    const Vec3 target = i % 3 == 1 ? to_float(on_edge) : vertex;
    const Vec3 away{component(), component(), component()};
    Ray& ray = rays[i];
    ray.origin = i % 5 == 0 ? to_float(surface.center) : to_float(surface.center + away);
    ray.direction = to_float(target - ray.origin);
    if (i % 3 != 2) continue;
    const double zero = random.sign() * 0.0;
    Vec3 along = to_float(surface.center), axis;
    const int which = random.integer(0, 2);
    (which == 0 ? along.y : along.x) = which == 0 ? vertex.y : vertex.x;
    (which == 2 ? along.y : along.z) = which == 2 ? vertex.y : vertex.z;
    if (length(along - surface.center) > 0.99 * surface.inner_radius) continue;
    axis = {which == 0 ? vertex.x - along.x : zero, which == 1 ? vertex.y - along.y : zero,
            which == 2 ? vertex.z - along.z : zero};
    if (length(axis) == 0) continue;
    ray.origin = along;
    ray.direction = axis;
  }
  return rays;
}

}  // namespace strahl::selftest
