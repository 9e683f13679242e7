// SPDX-License-Identifier: MIT
#pragma once

#include "scene/model/scene.h"
#include "settings/settings.h"

namespace strahl {

/// What a render with these settings is of: the scene without media of nothing (empty_media.h), unless values are asked
/// for in which their boundaries show.
[[nodiscard]] Scene shown_scene(Scene scene, const RenderSettings& settings);

}  // namespace strahl
