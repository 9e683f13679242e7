// SPDX-License-Identifier: MIT
// <medium> and <phase>.
#pragma once

#include "scene/xml/properties.h"
#include "scene/xml/scene_builder.h"

namespace strahl {

/// Index into Scene::media of a <medium>, which is read once; -1, after a warning: strahl does not have it.
[[nodiscard]] int medium_index(const XmlElement& element, SceneBuilder& builder);

/// `interior` and `exterior` of a shape; none where it has neither.
[[nodiscard]] std::optional<MediumBoundary> read_boundary(Properties& shape, SceneBuilder& builder);

}  // namespace strahl
