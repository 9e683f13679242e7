// SPDX-License-Identifier: MIT
// How bright a picture of the scene will typically be: decides the film's unit, never a value in the picture.
#include <algorithm>
#include <cmath>
#include <limits>

#include "device/pack.h"

namespace strahl {
namespace {

double largest(const Rgb& c) { return std::max({c.r, c.g, c.b}); }

/// How far what a light shines on typically is: the scene's middle, or half its size where that is nearer; the nearest
/// plane where nothing is bounded.
double typical_distance(const Vec3& light, const Scene& scene, const std::optional<Box>& box) {
  if (box) return std::max(length(light - 0.5 * (box->min + box->max)), 0.5 * length(box->max - box->min));
  double nearest = std::numeric_limits<double>::infinity();
  for (const Shape& shape : scene.shapes)
    if (const auto* plane = std::get_if<Plane>(&shape.geometry))
      nearest = std::min(nearest, std::abs(dot(normalized(plane->normal), light - plane->point)));
  return nearest;
}

/// Radiance of a white diffuse surface at the typical distance.
double reflected(const PointLight& light, const Scene& scene, const std::optional<Box>& box) {
  const double distance = typical_distance(light.position, scene, box);
  return distance > 0 ? largest(light.intensity) / (distance * distance) : largest(light.intensity);
}

double typical_radiance(const Scene& scene) {
  const std::optional<Box> box = bounds(scene);
  const std::string& integrator = scene.integrator.name;
  if (integrator == "normals" || integrator == "ao") return 1;
  if (integrator == "depth")
    return box ? length(box->max - box->min) +
                     length(0.5 * (box->min + box->max) - scene.camera.world_from_camera.translation())
               : 1;
  double radiance = 0;
  for (const Shape& shape : scene.shapes) {
    if (shape.radiance) radiance = std::max(radiance, largest(*shape.radiance));
    if (const auto* mesh = std::get_if<Mesh>(&shape.geometry))
      for (const MeshPart& part : mesh->parts)
        if (part.radiance) radiance = std::max(radiance, largest(*part.radiance));
  }
  for (const Light& light : scene.lights) {
    if (const auto* point = std::get_if<PointLight>(&light.emitter))
      radiance = std::max(radiance, reflected(*point, scene, box));
    if (const auto* sun = std::get_if<DirectionalLight>(&light.emitter))
      radiance = std::max(radiance, largest(sun->irradiance));
    if (const auto* sky = std::get_if<ConstantLight>(&light.emitter))
      radiance = std::max(radiance, largest(sky->radiance));
  }
  return radiance;
}

}  // namespace

double film_scale(const Scene& scene) {
  const double typical = typical_radiance(scene);
  const int exponent = typical > 0 && std::isfinite(typical) ? std::ilogb(typical) : 0;
  // Representable in fp32 whatever the scene says.
  return std::ldexp(1.0, std::clamp(28 - exponent, -100, 100));
}

}  // namespace strahl
