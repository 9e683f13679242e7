// SPDX-License-Identifier: MIT
#include "scene/unseen.h"

#include <algorithm>
#include <array>
#include <optional>

#include "kinds/materials.h"

namespace strahl {
namespace {

/// From both sides.
bool passes_all(const Scene& scene, int index) {
  const Material& material = scene.materials.at(static_cast<std::size_t>(index));
  const std::optional<MaterialSlot> opacity = material_facts(material).opacity;
  if (!opacity || opacity->texture >= 0 || opacity->reals != std::array<double, 3>{}) return false;
  return material.back < 0 || passes_all(scene, material.back);
}

bool is_masked(const Scene& scene, int index) {
  const Material& material = scene.materials.at(static_cast<std::size_t>(index));
  const auto is_mask = [](const Material& each) { return each.opacity.has_value(); };
  return is_mask(material) || any_inside(scene, material, is_mask, true);
}

}  // namespace

bool is_unseen(const Shape& shape, const Scene& scene) {
  const auto* mesh = std::get_if<Mesh>(&shape.geometry);
  if (mesh == nullptr || mesh->parts.empty()) return !shape.radiance && passes_all(scene, shape.material);
  return std::all_of(mesh->parts.begin(), mesh->parts.end(),
                     [&](const MeshPart& part) { return !part.radiance && passes_all(scene, part.material); });
}

bool is_masked(const Shape& shape, const Scene& scene) {
  const auto* mesh = std::get_if<Mesh>(&shape.geometry);
  if (mesh == nullptr || mesh->parts.empty()) return is_masked(scene, shape.material);
  return std::any_of(mesh->parts.begin(), mesh->parts.end(),
                     [&](const MeshPart& part) { return is_masked(scene, part.material); });
}

bool has_panes(const Scene& scene) {
  return std::ranges::any_of(
      scene.materials, [](const Material& material) { return std::holds_alternative<ThinDielectric>(material.bsdf); });
}

}  // namespace strahl
