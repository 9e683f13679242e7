// SPDX-License-Identifier: MIT
#include "packing/pack_materials.h"

#include "kinds/textures.h"

namespace strahl {

PackedMaterial packed_material(const Material& material, const Scene& scene, const Features& features) {
  const MaterialFacts facts = material_facts(material);
  PackedMaterial packed{features.entry_index("materials", facts.kind), facts.is_twosided, facts.slots};
  for (MaterialSlot& slot : packed.slots) {
    if (slot.texture < 0) continue;
    const Texture& texture = scene.textures[static_cast<std::size_t>(slot.texture)];
    const kinds::TextureFacts facts_of_texture = kinds::texture(texture);
    if (features.has("textures", facts_of_texture.entry)) continue;
    slot.texture = -1;
    slot.reals = {facts_of_texture.mean.r, facts_of_texture.mean.g, facts_of_texture.mean.b};
  }
  return packed;
}

}  // namespace strahl
