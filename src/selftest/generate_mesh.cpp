// SPDX-License-Identifier: MIT
// Closed convex meshes, rays from inside at what their triangles share.
#include <array>
#include <cmath>

#include "selftest/generators.h"

namespace strahl::selftest {
namespace {

using Face = std::array<Vec3, 3>;

/// Rounds the vertices of the mesh around the point, then asks it from a point within: at edges and vertices.
Question ask(Draft& draft, std::vector<Face> faces, const Vec3& within) {
  const double size = draft.size("size", 1);
  const Vec3 center = draft.place();
  Question q = question_about("triangle");
  for (Face& face : faces)
    for (Vec3& vertex : face) put(q, vertex = to_float(center + size * vertex));
  const Face& aimed = faces[static_cast<std::size_t>(draft.random.integer(0, static_cast<int>(faces.size()) - 1))];
  const int place = draft.random.integer(0, 2);
  const double along = place == 0 ? 0 : place == 1 ? 0.5 : draft.random.uniform();
  const Vec3 target = aimed[0] + along * (aimed[1] - aimed[0]), origin = to_float(center + size * within);
  aim(q, origin, draft.scaled(1 / std::fmax(size, length(target - origin)) * (target - origin)));
  return q;
}

/// Two tips and a ring of `valence` vertices, stretched along the axis by `stretch`, in any position.
Question bipyramid(Draft& draft) {
  const int valence = draft.whole("valence", 6);
  const double stretch = draft.size("stretch", 1);
  const Vec3 axis = draft.direction(), a = draft.perpendicular(axis), b = cross(axis, a);
  std::vector<Vec3> ring;
  for (int i = 0; i < valence; ++i) {
    const double turn = 6.283185307179586 * i / valence;
    ring.push_back(std::cos(turn) * a + std::sin(turn) * b);
  }
  std::vector<Face> faces;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3 &from = ring[i], &to = ring[(i + 1) % ring.size()];
    faces.push_back({stretch * axis, from, to});
    faces.push_back({-stretch * axis, to, from});
  }
  return ask(draft, faces, draft.random.uniform(0, 0.2) * draft.direction());
}

/// A cube of `cells` x `cells` squares a side, each two triangles; every coordinate a multiple of a power of two.
/// Rays start at lattice points, along lattice directions or parallel to an axis.
Question lattice(Draft& draft) {
  const int n = draft.whole("cells", 4);
  const double size = draft.size("size", 1);
  const Vec3 center{draft.size("offset", 0), 0, -draft.size("offset", 0)};
  const auto turned = [&](int axis, double out, double x, double y) {
    const Vec3 p = axis == 0 ? Vec3{out, x, y} : axis == 1 ? Vec3{y, out, x} : Vec3{x, y, out};
    return to_float(center + size * p);
  };
  Question q = question_about("triangle");
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0})
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
          const double x0 = 2.0 * i / n - 1, x1 = 2.0 * (i + 1) / n - 1, y0 = 2.0 * j / n - 1;
          const double y1 = 2.0 * (j + 1) / n - 1;
          const Vec3 a = turned(axis, side, x0, y0), c = turned(axis, side, x1, y1);
          for (const Vec3& v : {a, turned(axis, side, x1, y0), c}) put(q, v);
          for (const Vec3& v : {a, c, turned(axis, side, x0, y1)}) put(q, v);
        }
  const auto cell = [&] { return 2.0 * draft.random.integer(1, n - 1) / n - 1; };
  const Vec3 origin = center + size * Vec3{cell(), cell(), cell()};
  Vec3 d{};
  while (d == Vec3{}) {
    const auto step = [&] { return draft.random.sign() * 1.0 * draft.random.integer(0, draft.index % 2); };
    d = {step(), step(), step()};
    if (draft.index % 2 == 0) {
      const int axis = draft.random.integer(0, 2);
      (axis == 0 ? d.x : axis == 1 ? d.y : d.z) = draft.random.sign();
    }
  }
  aim(q, origin, draft.scaled(d));
  return q;
}

/// 16 x 16 squares of a sphere, every vertex at a radius of 1 to 6; rays from within a half.
Question displaced(Draft& draft) {
  constexpr int n = 16;
  const Vec3 center = draft.place();
  std::vector<Vec3> vertices;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j < n; ++j) {
      if ((i == 0 || i == n) && j > 0) {
        vertices.push_back(vertices.back());  // a pole
        continue;
      }
      const double theta = 3.141592653589793 * i / n, phi = 2 * 3.141592653589793 * j / n;
      const double radius = draft.random.uniform(1, 6);
      vertices.push_back(to_float(
          center + radius * Vec3{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)}));
    }
  const auto vertex = [&](int i, int j) { return vertices[static_cast<std::size_t>(i * n + j % n)]; };
  Question q = question_about("triangle");
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      if (i > 0)
        for (const Vec3& p : {vertex(i, j), vertex(i + 1, j), vertex(i, j + 1)}) put(q, p);
      if (i < n - 1)
        for (const Vec3& p : {vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)}) put(q, p);
    }
  const Vec3 origin = to_float(center + draft.random.uniform(0, 0.5) * draft.direction());
  const Vec3 target = vertex(draft.random.integer(0, n), draft.random.integer(0, n));
  aim(q, origin, draft.index % 2 == 0 ? draft.direction() : normalized(target - origin));
  return q;
}

}  // namespace

const std::vector<Generator> mesh_generators = {{"mesh_bipyramid", bipyramid, Surface::convex},
                                                {"mesh_lattice", lattice, Surface::convex},
                                                {"mesh_displaced", displaced, Surface::closed}};

}  // namespace strahl::selftest
