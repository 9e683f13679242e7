// SPDX-License-Identifier: MIT
#include "scene/empty_media.h"

#include <algorithm>
#include <array>
#include <optional>

#include "kinds/integrators.h"
#include "kinds/materials.h"
#include "scene/auto_integrator.h"

namespace strahl {
namespace {

/// Emission is that of the share of light that a medium absorbs, so this glows no more than it absorbs.
bool is_empty(const Medium& medium) { return medium.sigma_t.largest() == Rgb{0, 0, 0}; }

bool passes_all(const Scene& scene, int index) {
  const std::optional<MaterialSlot> opacity =
      material_facts(scene.materials.at(static_cast<std::size_t>(index))).opacity;
  return opacity && opacity->texture < 0 && opacity->reals == std::array<double, 3>{};
}

bool is_unseen(const Scene& scene, const Shape& shape) {
  const auto* mesh = std::get_if<Mesh>(&shape.geometry);
  if (mesh == nullptr || mesh->parts.empty()) return !shape.radiance && passes_all(scene, shape.material);
  return std::all_of(mesh->parts.begin(), mesh->parts.end(),
                     [&](const MeshPart& part) { return !part.radiance && passes_all(scene, part.material); });
}

}  // namespace

void leave_out_empty_media(Scene& scene) {
  if (!kinds::integrator(scene.integrator.name).goes_through) return;
  if (!std::all_of(scene.media.begin(), scene.media.end(), is_empty)) return;
  scene.media.clear();
  scene.camera.medium = -1;
  std::erase_if(scene.shapes, [&](const Shape& shape) { return is_unseen(scene, shape); });
  for (Shape& shape : scene.shapes) shape.media.reset();
  for (Group& group : scene.groups)
    for (Shape& shape : group.shapes) shape.media.reset();
  simplify_integrator(scene);
}

}  // namespace strahl
