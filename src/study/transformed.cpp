// SPDX-License-Identifier: MIT
#include "study/transformed.h"

#include <algorithm>
#include <utility>

namespace strahl {
namespace {

struct Moved {
  const MapVec3& point;
  const MapVec3& vector;

  void operator()(Sphere& s) const { s.center = point(s.center); }
  void operator()(Plane& p) const {
    p.point = point(p.point);
    p.u = vector(p.u);
    p.v = vector(p.v);
  }
  void operator()(Box& b) const {
    const Vec3 a = point(b.min), c = point(b.max);
    b.min = {std::min(a.x, c.x), std::min(a.y, c.y), std::min(a.z, c.z)};
    b.max = {std::max(a.x, c.x), std::max(a.y, c.y), std::max(a.z, c.z)};
  }
  void operator()(Triangle& t) const {
    for (Vec3* p : {&t.p0, &t.p1, &t.p2}) *p = point(*p);
  }
  void operator()(Rectangle& r) const {
    r.corner = point(r.corner);
    r.edge_u = vector(r.edge_u);
    r.edge_v = vector(r.edge_v);
  }
  void operator()(Cube& c) const {
    c.corner = point(c.corner);
    for (Vec3& edge : c.edge) edge = vector(edge);
  }
  void operator()(Disk& d) const {
    d.center = point(d.center);
    d.axis_u = vector(d.axis_u);
    d.axis_v = vector(d.axis_v);
  }
  void operator()(Cylinder& c) const {
    c.p0 = point(c.p0);
    c.p1 = point(c.p1);
  }
  void operator()(Mesh& m) const {
    for (Vec3& p : m.positions) p = point(p);
  }
  void operator()(SphereCloud& cloud) const {
    for (SphereCloud::Ball& ball : cloud.spheres) ball.center = point(ball.center);
  }
};

void scale_radius(Geometry& geometry, double factor) {
  if (auto* sphere = std::get_if<Sphere>(&geometry)) sphere->radius *= factor;
  if (auto* cylinder = std::get_if<Cylinder>(&geometry)) cylinder->radius *= factor;
  if (auto* cloud = std::get_if<SphereCloud>(&geometry))
    for (SphereCloud::Ball& ball : cloud->spheres) ball.radius *= factor;
}

Vec3 flipped(const Vec3& v) { return {-v.x, v.y, v.z}; }

/// Column 3 is the translation.
void set_column(Transform& transform, std::size_t column, const Vec3& v) {
  transform.m[0][column] = v.x;
  transform.m[1][column] = v.y;
  transform.m[2][column] = v.z;
}

/// Directions that are no edges of anything, and sides.
void mirror_orientation(Shape& shape) {
  if (auto* sphere = std::get_if<Sphere>(&shape.geometry))
    for (Vec3& axis : sphere->frame) axis = flipped(axis);
  if (auto* cloud = std::get_if<SphereCloud>(&shape.geometry))
    for (Vec3& axis : cloud->frame) axis = flipped(axis);
  if (auto* plane = std::get_if<Plane>(&shape.geometry)) plane->normal = flipped(plane->normal);
  if (auto* cylinder = std::get_if<Cylinder>(&shape.geometry)) cylinder->reference = flipped(cylinder->reference);
  // A normal from a cross product points to the other side of a mirrored shape, and flipping turns a mesh's too.
  if (auto* mesh = std::get_if<Mesh>(&shape.geometry))
    for (Vec3& normal : mesh->normals) normal = -flipped(normal);
  const Geometry& g = shape.geometry;
  const bool is_crossed = std::holds_alternative<Rectangle>(g) || std::holds_alternative<Disk>(g) ||
                          std::holds_alternative<Triangle>(g) || std::holds_alternative<Mesh>(g);
  if (is_crossed) shape.flip_normals = !shape.flip_normals;
}

}  // namespace

Scene with_places(Scene scene, const MapVec3& place, const MapVec3& vector) {
  for (Shape& shape : scene.shapes) std::visit(Moved{place, vector}, shape.geometry);
  for (Instance& instance : scene.instances) {
    Transform& world = instance.world_from_group;
    for (const int column : {0, 1, 2})
      set_column(world, static_cast<std::size_t>(column), vector(world.column(column)));
    set_column(world, 3, place(world.translation()));
  }
  for (Light& light : scene.lights)
    if (auto* lamp = std::get_if<PointLight>(&light.emitter)) lamp->position = place(lamp->position);
  set_column(scene.camera.world_from_camera, 3, place(scene.camera.world_from_camera.translation()));
  return scene;
}

Scene scaled(Scene scene, double factor) {
  const auto scale = [factor](const Vec3& v) { return factor * v; };
  scene = with_places(std::move(scene), scale, scale);
  for (Shape& shape : scene.shapes) scale_radius(shape.geometry, factor);
  for (Light& light : scene.lights)
    if (auto* lamp = std::get_if<PointLight>(&light.emitter)) {
      const double area = factor * factor;
      lamp->intensity = {area * lamp->intensity.r, area * lamp->intensity.g, area * lamp->intensity.b};
    }
  Camera& camera = scene.camera;
  // An orthographic camera's window is as wide as its axes are long; a perspective one's axes have no size.
  if (camera.projection == Projection::orthographic)
    for (const int column : {0, 1})
      set_column(camera.world_from_camera, static_cast<std::size_t>(column),
                 factor * camera.world_from_camera.column(column));
  camera.near_clip *= factor;
  camera.far_clip *= factor;
  return scene;
}

Scene translated(Scene scene, const Vec3& by) {
  return with_places(
      std::move(scene), [&](const Vec3& p) { return p + by; }, [](const Vec3& v) { return v; });
}

Scene mirrored(Scene scene) {
  scene = with_places(std::move(scene), flipped, flipped);
  for (Shape& shape : scene.shapes) mirror_orientation(shape);
  for (Light& light : scene.lights)
    if (auto* sun = std::get_if<DirectionalLight>(&light.emitter)) sun->direction = flipped(sun->direction);
  Transform& world = scene.camera.world_from_camera;
  for (const int column : {0, 1, 2}) {
    const Vec3 axis = flipped(world.column(column));
    set_column(world, static_cast<std::size_t>(column), column == 0 ? -axis : axis);
  }
  return scene;
}

Scene reordered(Scene scene) {
  std::reverse(scene.shapes.begin(), scene.shapes.end());
  std::reverse(scene.instances.begin(), scene.instances.end());
  return scene;
}

}  // namespace strahl
