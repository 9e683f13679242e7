// SPDX-License-Identifier: MIT
#include "render/limitations.h"

namespace strahl {

std::vector<Diagnostic> limitations(const Scene& scene) {
  std::vector<Diagnostic> warnings;
  if (scene.integrator.name != "direct" || (scene.integrator.max_depth >= 0 && scene.integrator.max_depth < 2))
    return warnings;
  const auto warn = [&](const SourceLocation& where, const char* message) {
    warnings.push_back({Severity::warning, where, message});
  };
  for (const Shape& shape : scene.shapes) {
    bool emits = shape.radiance.has_value();
    if (const auto* mesh = std::get_if<Mesh>(&shape.geometry))
      for (const MeshPart& part : mesh->parts) emits = emits || part.radiance;
    if (emits)
      warn(shape.radiance_where.line > 0 ? shape.radiance_where : shape.where,
           "this area emitter is seen but does not light the scene: integrator direct uses point and directional "
           "lights so far");
  }
  for (const Light& light : scene.lights)
    if (std::holds_alternative<ConstantLight>(light.emitter))
      warn(light.where,
           "the constant emitter is seen as background but does not light the scene: integrator direct uses point and "
           "directional lights so far");
  return warnings;
}

}  // namespace strahl
