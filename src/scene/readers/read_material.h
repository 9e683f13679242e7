// SPDX-License-Identifier: MIT
// <bsdf> elements as materials: a reader for each entry of the kernels' list, which the linker names where it is
// missing.
#pragma once

#include "scene/xml/properties.h"
#include "scene/xml/scene_builder.h"

namespace strahl {

/// Fills `bsdf` and `twosided`; the rest is done by material_of().
using MaterialReader = Material (*)(Properties&, SceneBuilder&);

#define MATERIAL(name, reals, lobes) Material read_##name(Properties& properties, SceneBuilder& builder);
#include "../../../cl/materials/materials.def"
#undef MATERIAL
/// No material of its own: it changes the one inside it.
Material read_twosided(Properties& properties, SceneBuilder& builder);
/// Nor these: a share of what is inside, and nothing.
Material read_mask(Properties& properties, SceneBuilder& builder);
Material read_null(Properties& properties, SceneBuilder& builder);
/// Nor these: two others, any number of others, and another with normals that a texture bends.
Material read_blend(Properties& properties, SceneBuilder& builder);
Material read_mixture(Properties& properties, SceneBuilder& builder);
Material read_normalmap(Properties& properties, SceneBuilder& builder);
Material read_bumpmap(Properties& properties, SceneBuilder& builder);
/// Nor these: filters of polarization are thin panes.
Material read_polarizer(Properties& properties, SceneBuilder& builder);
Material read_circular(Properties& properties, SceneBuilder& builder);
Material read_retarder(Properties& properties, SceneBuilder& builder);
/// Nor this: a layer over another.
Material read_coating(Properties& properties, SceneBuilder& builder);

/// The material that a <bsdf> describes; each element is read once. An unknown type is replaced with a warning.
[[nodiscard]] Material material_of(const XmlElement& bsdf, SceneBuilder& builder);

/// What a bsdf of type null is: it reflects nothing, and no ray meets it.
[[nodiscard]] Material null_material();

/// Appends it to builder.scene.materials, and returns its index.
int add_material(const Material& material, SceneBuilder& builder);

/// Its index in builder.scene.materials, appended at first use.
[[nodiscard]] int material_index(const XmlElement& bsdf, SceneBuilder& builder);

}  // namespace strahl
