// SPDX-License-Identifier: MIT
#include "scene/beams.h"

#include <algorithm>

#include "kinds/lights.h"

namespace strahl {
std::vector<SourceLocation> beams_of(const Scene& scene) {
  std::vector<SourceLocation> found;
  for (const Light& light : scene.lights)
    if (kinds::light(light).is_beam && kinds::gives_light(light)) found.push_back(light.where);
  for (const Shape& shape : scene.shapes)
    if (shape.exitance && kinds::gives_light(*shape.exitance)) found.push_back(shape.radiance_where);
  return found;
}

bool has_beams_alone(const Scene& scene) {
  const auto is_other = [](const Light& light) { return !kinds::light(light).is_beam && kinds::gives_light(light); };
  const auto shines = [](const Shape& shape) { return kinds::gives_light(shape); };
  const auto emits = [](const Medium& medium) { return kinds::gives_light(medium.emission.largest()); };
  return !beams_of(scene).empty() && std::none_of(scene.lights.begin(), scene.lights.end(), is_other) &&
         std::none_of(scene.shapes.begin(), scene.shapes.end(), shines) &&
         std::none_of(scene.media.begin(), scene.media.end(), emits);
}

}  // namespace strahl
