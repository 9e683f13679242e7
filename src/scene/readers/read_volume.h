// SPDX-License-Identifier: MIT
// <volume>, and parameters that can be one.
#pragma once

#include <optional>

#include "scene/model/volume.h"
#include "scene/xml/properties.h"
#include "scene/xml/scene_builder.h"

namespace strahl {

/// The parameter `name`: a colour, a constvolume, or, where `can_vary`, a gridvolume. None: it is absent, or, after a
/// warning, nothing that strahl has.
[[nodiscard]] std::optional<Volume> read_volume(Properties& properties, SceneBuilder& builder, const char* name,
                                                ColorUse use, const Rgb& substitute, bool can_vary);

/// Makes what is alike everywhere a grid of one texel, which fills the unit cube alone, as Mitsuba's heterogeneous
/// does.
void make_grid(Volume& volume);

}  // namespace strahl
