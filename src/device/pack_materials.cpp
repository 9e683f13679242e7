// SPDX-License-Identifier: MIT
#include "device/pack_materials.h"

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
  PackedMaterial packed;
  packed.kind = features.entry_index("materials", material_kind(material));
  packed.texture = material_texture(material);
  packed.reflectance = std::visit([](const auto& bsdf) { return bsdf.reflectance; }, material.bsdf);
  if (packed.texture < 0) return packed;
  const Texture& texture = scene.textures[static_cast<std::size_t>(packed.texture)];
  if (!features.has("textures", texture_kind(texture))) {
    packed.texture = -1;
    packed.reflectance = std::visit(Mean{}, texture.pattern);
  }
  return packed;
}

}  // namespace strahl
