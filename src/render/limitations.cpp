// SPDX-License-Identifier: MIT
#include "render/limitations.h"

#include <fmt/format.h>

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
  const bool follows_mirrors = integrator == "whitted";
  const bool is_lit = follows_mirrors || integrator == "direct";
  if (!is_lit || (scene.integrator.max_depth >= 0 && scene.integrator.max_depth < 2)) return warnings;
  const auto warn = [&](const SourceLocation& where, std::string message) {
    warnings.push_back({Severity::warning, where, std::move(message)});
  };
  for (const Material& material : scene.materials)
    if (std::holds_alternative<Conductor>(material.bsdf) && !follows_mirrors)
      warn(material.where, "this mirror looks black: integrator direct does not follow mirrors, whitted does");
  for (const Shape& shape : scene.shapes)
    if (emits(shape))
      warn(shape.radiance_where.line > 0 ? shape.radiance_where : shape.where,
           fmt::format("this area emitter is seen but does not light the scene: integrator {} uses point and "
                       "directional lights so far",
                       integrator));
  for (const Light& light : scene.lights)
    if (std::holds_alternative<ConstantLight>(light.emitter))
      warn(light.where, fmt::format("the constant emitter is seen as background but does not light the scene: "
                                    "integrator {} uses point and directional lights so far",
                                    integrator));
  return warnings;
}

}  // namespace strahl
