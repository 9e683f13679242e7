// SPDX-License-Identifier: MIT
// Building a scene in C++ instead of reading it from a file (docs/example).
#pragma once

#include "scene/model/scene.h"

namespace strahl {

/// The infinite plane through `point`; `normal` has any finite length > 0.
[[nodiscard]] Plane plane_through(const Vec3& point, const Vec3& normal);

/// A shape that emits `radiance` on the side that its normal points to (a sphere: outwards).
[[nodiscard]] Shape emitting(Geometry geometry, const Rgb& radiance);

/// A pinhole at `origin` that looks at `target`, the picture `fov_degrees` wide, its upper edge towards `up`. Throws
/// SceneError where origin and target coincide or `up` is parallel to the view.
[[nodiscard]] Camera perspective_camera(const Vec3& origin, const Vec3& target, const Vec3& up, double fov_degrees);

// Each puts something into the scene and returns its index there.
int add(Scene& scene, Shape shape);
int add(Scene& scene, Geometry geometry, int material = 0);
/// Shapes for instances to place; seen nowhere by themselves.
int add(Scene& scene, Group group);
/// Places the group of that index.
int add_instance(Scene& scene, int group, const Transform& world_from_group);
/// Indices of materials are what add(scene, geometry, material) takes; 0 is the scene's own grey.
int add(Scene& scene, const decltype(Material::bsdf)& material, bool twosided = false);
/// Any emitter outside shapes: each alternative of Light::emitter.
int add(Scene& scene, const decltype(Light::emitter)& emitter);

}  // namespace strahl
