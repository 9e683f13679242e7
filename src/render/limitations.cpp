// SPDX-License-Identifier: MIT
#include "render/limitations.h"

#include "device/pack_areas.h"
namespace strahl {

namespace {

bool emits(const Shape& shape) {
  bool any = shape.radiance.has_value();
  if (const auto* mesh = std::get_if<Mesh>(&shape.geometry))
    for (const MeshPart& part : mesh->parts) any = any || part.radiance;
  return any;
}

}  // namespace

std::vector<Diagnostic> limitations(const Scene& scene) {
  std::vector<Diagnostic> warnings;
  const std::string& integrator = scene.integrator.name;
  const bool is_direct = integrator == "direct", is_whitted = integrator == "whitted";
  if (!(is_direct || is_whitted) || (scene.integrator.max_depth >= 0 && scene.integrator.max_depth < 2))
    return warnings;
  const auto warn = [&](const SourceLocation& where, std::string message) {
    warnings.push_back({Severity::warning, where, std::move(message)});
  };
  for (const Material& material : scene.materials)
    if (std::holds_alternative<Conductor>(material.bsdf) && is_direct)
      warn(material.where, "this mirror shows emitters alone: integrator direct does not follow mirrors, whitted does");
  for (const Shape& shape : scene.shapes)
    if (emits(shape) && is_whitted && area_kind(shape.geometry).empty())
      warn(shape.radiance_where.line > 0 ? shape.radiance_where : shape.where,
           "this area emitter is seen but does not light the scene: its area is infinite, so that integrator whitted "
           "cannot draw places on it; direct and path find it");
  return warnings;
}

}  // namespace strahl
