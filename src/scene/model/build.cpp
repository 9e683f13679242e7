// SPDX-License-Identifier: MIT
#include "scene/model/build.h"

#include <utility>

#include "scene/model/transforms.h"

namespace strahl {
namespace {

template <typename Element>
int append(std::vector<Element>& elements, Element element) {
  elements.push_back(std::move(element));
  return static_cast<int>(elements.size()) - 1;
}

}  // namespace

Plane plane_through(const Vec3& point, const Vec3& normal) {
  const auto [u, v] = orthonormal_basis(normalized(normal));
  return {point, normal, u, v};
}

Shape emitting(Geometry geometry, const Rgb& radiance) {
  Shape shape;
  shape.geometry = std::move(geometry);
  shape.radiance = radiance;
  return shape;
}

Camera perspective_camera(const Vec3& origin, const Vec3& target, const Vec3& up, double fov_degrees) {
  const std::optional<Transform> view = look_at(origin, target, up);
  if (!view)
    throw SceneError({{Severity::error,
                       {},
                       "the camera has no view: origin and target must differ, and up must not be parallel to the line "
                       "between them"}});
  Camera camera;
  camera.world_from_camera = *view;
  camera.fov_degrees = fov_degrees;
  return camera;
}

int add(Scene& scene, Shape shape) { return append(scene.shapes, std::move(shape)); }

int add(Scene& scene, Group group) { return append(scene.groups, std::move(group)); }

int add_instance(Scene& scene, int group, const Transform& world_from_group) {
  return append(scene.instances, {{}, group, world_from_group, {}});
}

int add(Scene& scene, Geometry geometry, int material) {
  Shape shape;
  shape.geometry = std::move(geometry);
  shape.material = material;
  return add(scene, std::move(shape));
}

int add(Scene& scene, const decltype(Material::bsdf)& material, bool twosided) {
  return append(scene.materials, {{}, material, twosided, {}});
}

int add(Scene& scene, const decltype(Light::emitter)& emitter) { return append(scene.lights, {{}, emitter, {}}); }

}  // namespace strahl
