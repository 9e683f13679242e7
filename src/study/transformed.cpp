// SPDX-License-Identifier: MIT
#include "study/transformed.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "kinds/lights.h"
#include "kinds/textures.h"
#include "scene/model/perpendicular.h"

namespace strahl {
namespace {

Vec3 flipped(const Vec3& v) { return {-v.x, v.y, v.z}; }

/// Column 3 is the translation.
void set_column(Transform& transform, std::size_t column, const Vec3& v) {
  transform.m[0][column] = v.x;
  transform.m[1][column] = v.y;
  transform.m[2][column] = v.z;
}

void mirror_orientation(Shape& shape) {
  const auto mirror = [](auto& geometry) { return kinds::mirror(geometry, flipped); };
  if (std::visit(mirror, shape.geometry) == kinds::Mirrored::flipped) shape.flip_normals = !shape.flip_normals;
}

/// Far off the ends of the axis are rounded, and the axis turns with them.
void turn_reference(Cylinder& cylinder) {
  if (cylinder.p0 == cylinder.p1) return;
  cylinder.reference = perpendicular(cylinder.reference, normalized(cylinder.p1 - cylinder.p0));
}

}  // namespace

Scene with_places(Scene scene, const MapVec3& place, const MapVec3& vector) {
  for (Shape& shape : scene.shapes)
    std::visit([&](auto& geometry) { kinds::move(geometry, place, vector); }, shape.geometry);
  const auto move = [&](Transform& world) {
    for (const int column : {0, 1, 2})
      set_column(world, static_cast<std::size_t>(column), vector(world.column(column)));
    set_column(world, 3, place(world.translation()));
  };
  for (Instance& instance : scene.instances) move(instance.world_from_group);
  for (Medium& medium : scene.media)
    for (Volume* volume : {&medium.sigma_t, &medium.albedo, &medium.emission}) move(volume->world_from_cube);
  for (Light& light : scene.lights) kinds::move(light, place);
  set_column(scene.camera.world_from_camera, 3, place(scene.camera.world_from_camera.translation()));
  return scene;
}

Scene scaled(Scene scene, double factor) {
  const auto scale = [factor](const Vec3& v) { return factor * v; };
  scene = with_places(std::move(scene), scale, scale);
  for (Shape& shape : scene.shapes) std::visit([&](auto& geometry) { kinds::scale(geometry, factor); }, shape.geometry);
  for (Light& light : scene.lights) kinds::scale(light, factor);
  Camera& camera = scene.camera;
  // An orthographic camera's window is as wide as its axes are long; a perspective one's axes have no size.
  if (camera.projection == Projection::orthographic)
    for (const int column : {0, 1})
      set_column(camera.world_from_camera, static_cast<std::size_t>(column),
                 factor * camera.world_from_camera.column(column));
  camera.aperture_radius *= factor;
  camera.focus_distance *= factor;
  camera.near_clip *= factor;
  camera.far_clip *= factor;
  scene.integrator.max_distance *= factor;
  for (Medium& medium : scene.media) medium.sigma_t.value = kinds::times(1 / factor, medium.sigma_t.value);
  for (Material& material : scene.materials)
    if (auto* relief = std::get_if<Relief>(&material.bsdf); relief != nullptr && relief->kind == Relief::Kind::heights)
      relief->scale *= factor;
  return scene;
}

Scene translated(Scene scene, const Vec3& by) {
  scene = with_places(
      std::move(scene), [&](const Vec3& p) { return p + by; }, [](const Vec3& v) { return v; });
  for (Shape& shape : scene.shapes)
    if (auto* cylinder = std::get_if<Cylinder>(&shape.geometry)) turn_reference(*cylinder);
  return scene;
}

Scene brightened(Scene scene, double factor) {
  const auto brighten = [factor](Rgb& c) { c = kinds::times(factor, c); };
  const auto brighten_shapes = [&](std::vector<Shape>& shapes) {
    for (Shape& shape : shapes) {
      if (shape.radiance) brighten(*shape.radiance);
      if (shape.exitance) brighten(*shape.exitance);
      if (auto* mesh = std::get_if<Mesh>(&shape.geometry))
        for (MeshPart& part : mesh->parts)
          if (part.radiance) brighten(*part.radiance);
    }
  };
  brighten_shapes(scene.shapes);
  for (Light& light : scene.lights) brighten(kinds::light_colour(light));
  for (Medium& medium : scene.media) brighten(medium.emission.value);
  return scene;
}

Scene with_lamp(Scene scene, double distance, double radius) {
  const Transform& camera = scene.camera.world_from_camera;
  const Vec3 eye = camera.translation(), behind = -normalized(camera.column(2));
  const std::optional<Box> box = bounds(scene);
  const double extent = box ? length(box->max - box->min) + length(0.5 * (box->min + box->max) - eye) : 1;
  const double radiance = 1 / (std::numbers::pi * radius * radius);
  Shape lamp;
  lamp.geometry = Sphere{eye + distance * extent * behind, distance * extent * radius};
  lamp.radiance = Rgb{radiance, radiance, radiance};
  if (scene.materials.empty()) scene.materials.emplace_back();
  scene.shapes.push_back(lamp);
  return scene;
}

Scene mirrored(Scene scene) {
  scene = with_places(std::move(scene), flipped, flipped);
  for (Shape& shape : scene.shapes) mirror_orientation(shape);
  for (Light& light : scene.lights) kinds::mirror(light, flipped);
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
