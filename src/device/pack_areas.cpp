// SPDX-License-Identifier: MIT
#include "device/pack_areas.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "device/pack_shapes.h"

namespace strahl {
namespace {

struct Kind {
  std::string operator()(const Sphere&) const { return "sphere"; }
  std::string operator()(const Plane&) const { return {}; }
  std::string operator()(const Box&) const { return "parallelogram"; }
  std::string operator()(const Triangle&) const { return "triangle"; }
  std::string operator()(const Rectangle&) const { return "parallelogram"; }
  std::string operator()(const Cube&) const { return "parallelogram"; }
  std::string operator()(const Disk&) const { return "disk"; }
  std::string operator()(const Cylinder&) const { return "cylinder"; }
  std::string operator()(const Mesh&) const { return "triangle"; }
  std::string operator()(const SphereCloud&) const { return "sphere"; }
};

/// Collects items and their areas.
class Items {
 public:
  Items(const Frame& frame, bool is_flipped) : frame_(frame), is_flipped_(is_flipped) {}

  /// Spanned by two edges, of which `share` emits; u x v is the shape's normal.
  void flat(const Vec3& corner, const Vec3& u, const Vec3& v, double share) {
    put(frame_.point(corner));
    put(frame_.vector(u));
    put(frame_.vector(v));
    put((is_flipped_ ? -1.0 : 1.0) * normalized(cross(u, v)));
    weights_.push_back(share * length(cross(frame_.vector(u), frame_.vector(v))));
  }
  void round(const std::vector<Vec3>& vectors, double area) {
    for (const Vec3& v : vectors) put(v);
    weights_.push_back(area);
  }
  void number(double x) { area_.items.push_back(x); }

  std::optional<EmittingArea> area() {
    for (double& weight : weights_)
      if (!std::isfinite(weight)) weight = 0;
    area_.size = std::accumulate(weights_.begin(), weights_.end(), 0.0);
    if (!(area_.size > 0 && std::isfinite(area_.size))) return std::nullopt;
    area_.side = is_flipped_ ? -1 : 1;
    area_.choices = alias_table(weights_);
    return std::move(area_);
  }

 private:
  void put(const Vec3& v) { area_.items.insert(area_.items.end(), {v.x, v.y, v.z}); }

  const Frame& frame_;
  bool is_flipped_;
  std::vector<double> weights_;
  EmittingArea area_;
};

struct Collector {
  const Frame& frame;
  int part;
  Items& items;

  void operator()(const Sphere& s) const {
    const double radius = frame.scale * s.radius;
    items.round({frame.point(s.center)}, 4 * std::numbers::pi * radius * radius);
    items.number(radius);
  }
  void operator()(const Plane&) const {}
  void operator()(const Box& b) const {
    const Vec3 size = b.max - b.min;
    faces({b.min, {Vec3{size.x, 0, 0}, Vec3{0, size.y, 0}, Vec3{0, 0, size.z}}});
  }
  void operator()(const Triangle& t) const { items.flat(t.p0, t.p1 - t.p0, t.p2 - t.p0, 0.5); }
  void operator()(const Rectangle& r) const { items.flat(r.corner, r.edge_u, r.edge_v, 1); }
  void operator()(const Cube& c) const { faces(c); }
  void operator()(const Disk& d) const { items.flat(d.center, d.axis_u, d.axis_v, std::numbers::pi); }
  void operator()(const Cylinder& c) const {
    const Vec3 axis = frame.vector(c.p1 - c.p0), first = frame.vector(c.radius * c.reference);
    const Vec3 second = cross(normalized(axis), first);
    items.round({frame.point(c.p0), axis, first, second}, 2 * std::numbers::pi * length(first) * length(axis));
  }
  void operator()(const Mesh& mesh) const {
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      if (!mesh.parts.empty() && mesh.part_of_triangle[i] != part) continue;
      const auto corner = [&](std::size_t k) { return mesh.positions[static_cast<std::size_t>(mesh.triangles[i][k])]; };
      items.flat(corner(0), corner(1) - corner(0), corner(2) - corner(0), 0.5);
    }
  }
  /// One sphere: each that emits is a part (shape_parts.h).
  void operator()(const SphereCloud& cloud) const {
    const auto& [center, radius] = cloud.spheres[static_cast<std::size_t>(part)];
    (*this)(Sphere{center, radius, cloud.frame});
  }

  /// As pack_shapes.cpp has them: outwards where the edges are right-handed (faces_inward).
  void faces(const Cube& cube) const {
    for (unsigned axis = 0; axis < 3; ++axis) {
      const Vec3 &u = cube.edge.at((axis + 1) % 3), &v = cube.edge.at((axis + 2) % 3);
      items.flat(cube.corner, v, u, 1);
      items.flat(cube.corner + cube.edge.at(axis), u, v, 1);
    }
  }
};

}  // namespace

std::vector<Choice> alias_table(const std::vector<double>& weights) {
  const double mean = std::accumulate(weights.begin(), weights.end(), 0.0) / static_cast<double>(weights.size());
  std::vector<double> rest(weights.size());
  std::vector<std::size_t> small, large;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    rest[i] = weights[i] / mean;
    (rest[i] < 1 ? small : large).push_back(i);
  }
  std::vector<Choice> table(weights.size());
  for (std::size_t i = 0; i < table.size(); ++i) table[i].other = static_cast<std::int32_t>(i);
  while (!small.empty() && !large.empty()) {
    const std::size_t less = small.back(), more = large.back();
    small.pop_back();
    table[less] = {static_cast<std::uint32_t>(std::ldexp(rest[less], 32)), static_cast<std::int32_t>(more)};
    rest[more] -= 1 - rest[less];
    if (rest[more] < 1) {
      large.pop_back();
      small.push_back(more);
    }
  }
  return table;
}

std::string area_kind(const Geometry& geometry) { return std::visit(Kind{}, geometry); }

bool is_area_of_primitives(const Geometry& geometry) {
  const auto* mesh = std::get_if<Mesh>(&geometry);
  return (mesh && mesh->parts.empty()) || std::holds_alternative<Triangle>(geometry) ||
         std::holds_alternative<Rectangle>(geometry) || std::holds_alternative<Cube>(geometry);
}

std::optional<EmittingArea> emitting_area(const Shape& shape, int part, const Frame& frame) {
  Items items(frame, shape.flip_normals != faces_inward(shape.geometry));
  std::visit(Collector{frame, part, items}, shape.geometry);
  return items.area();
}

}  // namespace strahl
