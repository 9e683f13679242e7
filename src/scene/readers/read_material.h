// SPDX-License-Identifier: MIT
// <bsdf> elements as materials; one reader each, registered in materials.def.
#pragma once

#include "scene/xml/properties.h"
#include "scene/xml/scene_builder.h"

namespace strahl {

/// Fills `bsdf` and `twosided`; the rest is done by material_of().
using MaterialReader = Material (*)(Properties&, SceneBuilder&);

#define MATERIAL(type, reader) Material reader(Properties& properties, SceneBuilder& builder);
#include "scene/readers/materials.def"
#undef MATERIAL

/// The material that a <bsdf> describes; each element is read once. An unknown type is replaced with a warning.
[[nodiscard]] Material material_of(const XmlElement& bsdf, SceneBuilder& builder);

/// Its index in builder.scene.materials, appended at first use.
[[nodiscard]] int material_index(const XmlElement& bsdf, SceneBuilder& builder);

}  // namespace strahl
