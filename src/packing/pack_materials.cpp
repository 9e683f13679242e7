// SPDX-License-Identifier: MIT
#include "packing/pack_materials.h"

#include <stdexcept>

#include "kinds/textures.h"
#include "packing/cl_layout.h"

namespace strahl {

namespace {

/// The greatest values of a slot. is_bound: of a bitmap and of what meshes have, whose values are then not read, at
/// most these.
Rgb brightest(const MaterialSlot& slot, const Scene& scene, bool is_bound) {
  if (slot.texture < 0) return {slot.reals[0], slot.reals[1], slot.reals[2]};
  const Texture& texture = scene.textures[static_cast<std::size_t>(slot.texture)];
  if (const auto* bitmap = std::get_if<Bitmap>(&texture.pattern); is_bound && bitmap != nullptr) return bitmap->scale;
  if (is_bound && std::holds_alternative<AttributeTexture>(texture.pattern)) return {1, 1, 1};
  return kinds::brightest(scene, slot.texture);
}

double scale_of_slots(const std::vector<MaterialSlot>& slots, const Scene& scene) {
  const auto scale = [&](bool is_bound) {
    const Rgb a = brightest(slots[0], scene, is_bound), b = brightest(slots[1], scene, is_bound);
    return scale_of_parts({a.r + b.r, a.g + b.g, a.b + b.b});
  };
  return scale(true) == 1 ? 1 : scale(false);
}

}  // namespace

PackedMaterial packed_material(std::size_t row, const Scene& scene, const Features& features, EntryNumbers& numbers) {
  const Material& material = scene.materials[row];
  const MaterialFacts facts = material_facts(material);
  PackedMaterial packed;
  if (facts.nested.empty()) packed.kind = numbers("materials", facts.kind);
  if (!facts.nested.empty()) packed.first = facts.nested[0];
  if (facts.nested.size() > 1) packed.second = facts.nested[1];
  if (facts.is_coat) packed.second = -2;
  if (facts.is_twosided) packed.back = material.back < 0 ? static_cast<int>(row) : material.back;
  packed.has_along = facts.has_along;
  if (facts.is_metal) packed.indices = layout::INDICES_OF_METAL;
  if (facts.is_boundary) packed.indices = layout::INDICES_OF_GLASS;
  packed.opacity = facts.opacity.value_or(packed.opacity);
  packed.slots = facts.slots;
  if (packed.slots.size() > layout::MATERIAL_MOST_SLOTS)
    throw std::logic_error("a material has more parameters than MATERIAL_MOST_SLOTS");
  if (facts.scale_slot >= 0 && (packed.slots[0].texture >= 0 || packed.slots[1].texture >= 0))
    packed.slots[static_cast<std::size_t>(facts.scale_slot)].reals[2] = scale_of_slots(packed.slots, scene);
  const auto replace_texture = [&](MaterialSlot& slot) {
    if (slot.texture < 0) return;
    const Texture& texture = scene.textures[static_cast<std::size_t>(slot.texture)];
    const kinds::TextureFacts facts_of_texture = kinds::texture(texture);
    if (features.has("textures", facts_of_texture.entry)) return;
    slot.texture = -1;
    slot.reals = {facts_of_texture.mean.r, facts_of_texture.mean.g, facts_of_texture.mean.b};
  };
  replace_texture(packed.opacity);
  for (MaterialSlot& slot : packed.slots) replace_texture(slot);
  return packed;
}

}  // namespace strahl
