// SPDX-License-Identifier: MIT
// How bright a picture of the scene will typically be: decides the film's unit, never a value in the picture.
#include <algorithm>
#include <cmath>

#include "device/pack.h"

namespace strahl {
namespace {

double largest(const Rgb& c) { return std::max({c.r, c.g, c.b}); }

/// Radiance of a white diffuse surface as far from the light as the scene's middle, or half its size where nearer.
double reflected(const PointLight& light, const std::optional<Box>& box) {
  double distance = 1;
  if (box) {
    const Vec3 middle = 0.5 * (box->min + box->max);
    distance = std::max(length(light.position - middle), 0.5 * length(box->max - box->min));
  }
  if (!(distance > 0)) distance = 1;
  return largest(light.intensity) / (distance * distance);
}

double typical_radiance(const Scene& scene) {
  const std::optional<Box> box = bounds(scene);
  const std::string& integrator = scene.integrator.name;
  if (integrator == "normals") return 1;
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
      radiance = std::max(radiance, reflected(*point, box));
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
