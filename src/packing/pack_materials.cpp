// SPDX-License-Identifier: MIT
#include "packing/pack_materials.h"

#include "kinds/entries.h"

namespace strahl {
namespace {

struct Mean {
  Rgb operator()(const Checkerboard& board) const {
    const Rgb &a = board.color0, &b = board.color1;
    return {0.5 * (a.r + b.r), 0.5 * (a.g + b.g), 0.5 * (a.b + b.b)};
  }
};

}  // namespace

PackedMaterial packed_material(const Material& material, const Scene& scene, const Features& features) {
  const MaterialFacts facts = material_facts(material);
  PackedMaterial packed{features.entry_index("materials", facts.kind), facts.is_twosided, facts.slots};
  for (MaterialSlot& slot : packed.slots) {
    if (slot.texture < 0) continue;
    const Texture& texture = scene.textures[static_cast<std::size_t>(slot.texture)];
    if (features.has("textures", texture_kind(texture))) continue;
    const Rgb mean = std::visit(Mean{}, texture.pattern);
    slot.texture = -1;
    slot.reals = {mean.r, mean.g, mean.b};
  }
  return packed;
}

}  // namespace strahl
