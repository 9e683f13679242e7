// SPDX-License-Identifier: MIT
// Metals by name, as Mitsuba has them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/model/materials.h"

namespace strahl {

/// Of "Au", "Cu", ...; "none" reflects everything. None where the name is unknown.
[[nodiscard]] std::optional<MetalIndex> metal_index(std::string_view name);

/// All of them, for messages.
[[nodiscard]] std::vector<std::string> metal_names();

}  // namespace strahl
