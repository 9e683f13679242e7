// SPDX-License-Identifier: MIT
// What can be asked of a scene: primitives of a shape, bounds of everything that is bounded.
#include "scene/scene.h"

#include <algorithm>
#include <cmath>

namespace strahl {

namespace {

class BoundsOf {
 public:
  void operator()(const Sphere& s) { add(s.center, {s.radius, s.radius, s.radius}); }
  void operator()(const Plane&) {}
  void operator()(const Box& b) { add(b.min), add(b.max); }
  void operator()(const Triangle& t) { add(t.p0), add(t.p1), add(t.p2); }
  void operator()(const Rectangle& r) {
    add(r.corner), add(r.corner + r.edge_u), add(r.corner + r.edge_v), add(r.corner + r.edge_u + r.edge_v);
  }
  void operator()(const Cube& c) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      Vec3 p = c.corner;
      for (unsigned i = 0; i < 3; ++i)
        if ((corner >> i & 1U) != 0) p = p + c.edge[i];
      add(p);
    }
  }
  void operator()(const Disk& d) {
    add(d.center,
        {std::hypot(d.axis_u.x, d.axis_v.x), std::hypot(d.axis_u.y, d.axis_v.y), std::hypot(d.axis_u.z, d.axis_v.z)});
  }
  void operator()(const Cylinder& c) {
    const Vec3 axis = normalized(c.p1 - c.p0);
    const auto extent = [&](double a) { return c.radius * std::sqrt(std::max(0.0, 1 - a * a)); };
    const Vec3 half{extent(axis.x), extent(axis.y), extent(axis.z)};
    add(c.p0, half), add(c.p1, half);
  }
  void operator()(const Mesh& mesh) {
    for (const Vec3& p : mesh.positions) add(p);
  }
  void operator()(const SphereCloud& cloud) {
    for (const auto& [center, radius] : cloud.spheres) add(center, {radius, radius, radius});
  }
  void add_turned(const Box& box, const Transform& transform) {
    for (unsigned corner = 0; corner < 8; ++corner)
      add(transform.point({(corner & 1U) != 0 ? box.max.x : box.min.x, (corner & 2U) != 0 ? box.max.y : box.min.y,
                           (corner & 4U) != 0 ? box.max.z : box.min.z}));
  }

  [[nodiscard]] const std::optional<Box>& box() const { return box_; }

 private:
  void add(const Vec3& p, const Vec3& half = {}) {
    if (!box_) box_ = Box{p - half, p + half};
    box_->min = {std::min(box_->min.x, p.x - half.x), std::min(box_->min.y, p.y - half.y),
                 std::min(box_->min.z, p.z - half.z)};
    box_->max = {std::max(box_->max.x, p.x + half.x), std::max(box_->max.y, p.y + half.y),
                 std::max(box_->max.z, p.z + half.z)};
  }

  std::optional<Box> box_;
};

}  // namespace

int primitive_count(const Shape& shape) {
  if (const Mesh* mesh = std::get_if<Mesh>(&shape.geometry)) return static_cast<int>(mesh->triangles.size());
  if (const auto* cloud = std::get_if<SphereCloud>(&shape.geometry)) return static_cast<int>(cloud->spheres.size());
  return std::holds_alternative<Cube>(shape.geometry) ? 6 : 1;
}

std::optional<Box> bounds(const Group& group) {
  BoundsOf all;
  for (const Shape& shape : group.shapes) std::visit(all, shape.geometry);
  return all.box();
}

std::optional<Box> bounds(const Scene& scene) {
  BoundsOf all;
  for (const Shape& shape : scene.shapes) std::visit(all, shape.geometry);
  std::vector<std::optional<Box>> of_groups;
  for (const Group& group : scene.groups) of_groups.push_back(bounds(group));
  for (const Instance& instance : scene.instances)
    if (const auto& box = of_groups.at(static_cast<std::size_t>(instance.group)))
      all.add_turned(*box, instance.world_from_group);
  return all.box();
}

}  // namespace strahl
