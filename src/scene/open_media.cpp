// SPDX-License-Identifier: MIT
#include "scene/open_media.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "kinds/integrators.h"

namespace strahl {
namespace {

/// What is full of a medium.
struct Body {
  const Shape* shape;
  int medium;
  Box box;
};

/// Integrals over a mesh's triangles. Of one without a border the area, as a vector, is zero, and the moments of
/// position by area are its volume along each axis and zero between two (the divergence theorem).
struct Hull {
  Vec3 area;                                       ///< Twice.
  std::array<std::array<double, 3>, 3> moments{};  ///< Six times; about the first corner.
  double surface = 0, moment = 0;  ///< Of the same, the sums of what the triangles contribute at the most.

  [[nodiscard]] double volume() const { return (moments[0][0] + moments[1][1] + moments[2][2]) / 3; }
};

Hull hull_of(const Mesh& mesh) {
  Hull hull;
  if (mesh.triangles.empty()) return hull;
  const auto corner = [&](const std::array<int, 3>& triangle, std::size_t i) {
    return mesh.positions.at(static_cast<std::size_t>(triangle.at(i)));
  };
  const Vec3 origin = corner(mesh.triangles.front(), 0);
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    const Vec3 a = corner(triangle, 0) - origin, b = corner(triangle, 1) - origin, c = corner(triangle, 2) - origin;
    const Vec3 across = cross(b - a, c - a), sum = a + b + c;
    hull.area = hull.area + across;
    hull.surface += length(across);
    hull.moment += length(across) * length(sum);
    const std::array<double, 3> along{sum.x, sum.y, sum.z}, normal{across.x, across.y, across.z};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) hull.moments[i][j] += along[i] * normal[j];
  }
  return hull;
}

bool is_closed(const Hull& hull) {
  constexpr double slack = 1e-6;
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      most = std::max(most, std::fabs(hull.moments[i][j] - (i == j ? hull.volume() : 0)));
  return length(hull.area) <= slack * hull.surface && most <= slack * hull.moment;
}

/// Which sides of a shape are which.
struct Sides {
  bool are_two = false;    ///< It is closed: one is its inside.
  bool is_turned = false;  ///< That one is before it.
};

/// Of a mesh its triangles say so, as flip_normals may have been changed for one that is mirrored.
Sides sides_of(const Shape& shape) {
  if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) {
    const Hull hull = hull_of(*mesh);
    return {is_closed(hull), shape.flip_normals != (hull.volume() < 0)};
  }
  const bool is_closed = std::holds_alternative<Sphere>(shape.geometry) ||
                         std::holds_alternative<SphereCloud>(shape.geometry) ||
                         std::holds_alternative<Box>(shape.geometry) || std::holds_alternative<Cube>(shape.geometry);
  return {is_closed, shape.flip_normals};
}

std::vector<Body> bodies_of(const Scene& scene) {
  std::vector<Body> bodies;
  for (const Shape& shape : scene.shapes) {
    if (!shape.media || shape.media->inside < 0) continue;
    const Sides sides = sides_of(shape);
    if (!sides.are_two || sides.is_turned) continue;
    if (const std::optional<Box> box = bounds(shape)) bodies.push_back({&shape, shape.media->inside, *box});
  }
  return bodies;
}

/// Up to what transforms round.
bool encloses(const Box& outer, const Box& inner) {
  const double slack = 1e-9 * length(outer.max - outer.min);
  const Vec3 low = inner.min - outer.min, high = outer.max - inner.max;
  return std::min({low.x, low.y, low.z, high.x, high.y, high.z}) >= -slack;
}

}  // namespace

std::optional<SourceLocation> open_medium(const Scene& scene) {
  if (!kinds::integrator(scene.integrator.name).goes_through || scene.media.empty()) return std::nullopt;
  const std::vector<Body> bodies = bodies_of(scene);
  // around: the box about which the medium is, none of what instances place. on: the shape that names the medium.
  const auto is_open = [&](int index, const std::optional<Box>& around, const Shape* on) {
    if (index < 0) return false;
    const Medium& medium = scene.media.at(static_cast<std::size_t>(index));
    if (medium.is_heterogeneous() || medium.sigma_t.largest() == Rgb{0, 0, 0}) return false;
    return std::none_of(bodies.begin(), bodies.end(), [&](const Body& body) {
      return body.medium == index && body.shape != on && (!around || encloses(body.box, *around));
    });
  };
  const Vec3 eye = scene.camera.world_from_camera.point({0, 0, 0});
  if (is_open(scene.camera.medium, Box{eye, eye}, nullptr)) return scene.camera.where;
  const auto is_open_at = [&](const Shape& shape, const std::optional<Box>& around) {
    if (!shape.media) return false;
    const auto [behind, before] = *shape.media;
    const auto [are_two, is_turned] = sides_of(shape);
    return is_open(is_turned ? behind : before, around, &shape) ||
           (!are_two && is_open(is_turned ? before : behind, around, &shape));
  };
  constexpr double far = std::numeric_limits<double>::max();
  const Box everywhere{{-far, -far, -far}, {far, far, far}};
  for (const Shape& shape : scene.shapes)
    if (shape.media && is_open_at(shape, bounds(shape).value_or(everywhere))) return shape.where;
  for (const Group& group : scene.groups)
    for (const Shape& shape : group.shapes)
      if (is_open_at(shape, std::nullopt)) return shape.where;
  return std::nullopt;
}

}  // namespace strahl
