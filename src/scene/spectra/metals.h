// SPDX-License-Identifier: MIT
// Complex indices of refraction of named metals and other conductors, as Mitsuba 3's RGB variants have them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/model/vec.h"

namespace strahl {

struct MetalIndex {
  Rgb eta;  ///< Real part.
  Rgb k;    ///< Imaginary part: absorption.
};

/// Of "Cu", "Au_palik", ...; case counts, as in Mitsuba. None where the name is unknown; "none", the ideal mirror, is
/// no metal.
[[nodiscard]] std::optional<MetalIndex> metal_index(std::string_view name);

/// All of them, for messages.
[[nodiscard]] std::vector<std::string> metal_names();

}  // namespace strahl
