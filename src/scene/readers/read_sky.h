// SPDX-License-Identifier: MIT
// <emitter type="sky">, "sun" and "sunsky": an image of the sky and a disc before it.
#pragma once

#include <optional>

#include "scene/xml/properties.h"
#include "scene/xml/scene_builder.h"

namespace strahl {

// Each returns the light that the emitter is; a sunsky appends its sun to the scene's lights by itself.
[[nodiscard]] std::optional<decltype(Light::emitter)> read_sky(Properties& properties, SceneBuilder& builder);
[[nodiscard]] std::optional<decltype(Light::emitter)> read_sun(Properties& properties, SceneBuilder& builder);
[[nodiscard]] std::optional<decltype(Light::emitter)> read_sunsky(Properties& properties, SceneBuilder& builder);

}  // namespace strahl
