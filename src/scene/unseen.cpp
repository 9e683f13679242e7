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

bool is_pane(const Material& material) { return std::holds_alternative<ThinDielectric>(material.bsdf); }

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

bool is_passed_boundary(const Shape& shape, const Scene& scene) {
  if (!shape.media) return false;
  const auto is_pane_at = [&](int material) { return is_pane(scene.materials.at(static_cast<std::size_t>(material))); };
  const auto* mesh = std::get_if<Mesh>(&shape.geometry);
  const bool is_glazed = mesh == nullptr || mesh->parts.empty()
                             ? is_pane_at(shape.material)
                             : std::ranges::any_of(mesh->parts, is_pane_at, &MeshPart::material);
  return is_glazed || is_masked(shape, scene);
}

bool has_glass(const Shape& shape, const Mesh* mesh, const Scene& scene) {
  const auto is_glass = [&](int material) {
    return material_facts(scene.materials.at(static_cast<std::size_t>(material))).is_boundary;
  };
  if (mesh == nullptr || mesh->parts.empty()) return is_glass(shape.material);
  return std::ranges::any_of(mesh->parts, is_glass, &MeshPart::material);
}

bool is_ranked(const Shape& shape, const Scene& scene) {
  return shape.priority &&
         (has_glass(shape, std::get_if<Mesh>(&shape.geometry), scene) || is_passed_boundary(shape, scene));
}

bool has_panes(const Scene& scene) { return std::ranges::any_of(scene.materials, is_pane); }

}  // namespace strahl
