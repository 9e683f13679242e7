// SPDX-License-Identifier: MIT
#include "scene/light_path_fault.h"

#include <fmt/format.h>

#include <algorithm>

#include "kinds/integrators.h"
#include "kinds/lights.h"
#include "scene/unseen.h"

namespace strahl {
namespace {

using Fault = std::optional<Diagnostic>;

Fault fault(const SourceLocation& where, const std::string& what) { return Diagnostic{Severity::error, where, what}; }

bool is_far(const Light& light) { return kinds::light(light).is_far && kinds::gives_light(light); }

/// Far lights enter through a disc as large as what is bounded, and an infinite area has no place to begin on.
Fault infinite_fault(const Scene& scene, const std::string& integrator) {
  const auto far = std::find_if(scene.lights.begin(), scene.lights.end(), is_far);
  for (const Shape& shape : scene.shapes) {
    if (bounds(shape)) continue;
    if (far != scene.lights.end())
      return fault(shape.where,
                   fmt::format("integrator {} cannot light an infinite shape from afar (a light of type {}): take a "
                               "large finite one, or integrator path",
                               integrator, kinds::light(*far).entry));
    if (shape.radiance || shape.exitance)
      return fault(shape.where, fmt::format("integrator {} cannot begin paths on an emitter of infinite area: take a "
                                            "large finite one, or integrator path",
                                            integrator));
  }
  return std::nullopt;
}

/// Which shapes a vertex is within is not kept, so that it could be joined with others.
Fault priority_fault(const Scene& scene, const std::string& integrator) {
  Fault found;
  for_each_shape(scene, [&](const Shape& shape) {
    if (!found && is_ranked(shape, scene))
      found = fault(shape.where, fmt::format("integrator {} does not know glass that overlaps by priority: leave the "
                                             "priority out, or take integrator path",
                                             integrator));
  });
  return found;
}

}  // namespace

std::optional<Diagnostic> light_path_fault(const Scene& scene, const std::string& integrator) {
  if (!scene.media.empty())
    return fault(scene.media.front().where,
                 fmt::format("integrator {} follows light between surfaces only, and here is a medium: take integrator "
                             "volpath",
                             integrator));
  if (kinds::integrator(integrator).from_camera)
    if (Fault found = priority_fault(scene, integrator)) return found;
  return infinite_fault(scene, integrator);
}

bool takes_light_paths(const Scene& scene, const std::string& integrator) {
  return scene.sampler.kind != SamplerKind::centre && !light_path_fault(scene, integrator);
}

}  // namespace strahl
