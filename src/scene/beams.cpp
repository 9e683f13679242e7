// SPDX-License-Identifier: MIT
#include "scene/beams.h"

#include <algorithm>

#include "kinds/lights.h"

namespace strahl {
namespace {

bool has_light(const Rgb& c) { return c.r > 0 || c.g > 0 || c.b > 0; }

bool emits_all_ways(const Shape& shape) {
  if (shape.radiance && has_light(*shape.radiance)) return true;
  const auto* mesh = std::get_if<Mesh>(&shape.geometry);
  return mesh != nullptr && std::any_of(mesh->parts.begin(), mesh->parts.end(), [](const MeshPart& part) {
           return part.radiance && has_light(*part.radiance);
         });
}

}  // namespace

std::vector<SourceLocation> beams_of(const Scene& scene) {
  std::vector<SourceLocation> found;
  for (const Light& light : scene.lights)
    if (kinds::light(light).is_beam && kinds::gives_light(light)) found.push_back(light.where);
  for (const Shape& shape : scene.shapes)
    if (shape.exitance && has_light(*shape.exitance)) found.push_back(shape.radiance_where);
  return found;
}

bool has_beams_alone(const Scene& scene) {
  const auto is_other = [](const Light& light) { return !kinds::light(light).is_beam && kinds::gives_light(light); };
  const auto emits = [](const Medium& medium) { return has_light(medium.emission.largest()); };
  return !beams_of(scene).empty() && std::none_of(scene.lights.begin(), scene.lights.end(), is_other) &&
         std::none_of(scene.shapes.begin(), scene.shapes.end(), emits_all_ways) &&
         std::none_of(scene.media.begin(), scene.media.end(), emits);
}

}  // namespace strahl
