// SPDX-License-Identifier: MIT
// Scenes of Mitsuba 0.x in the names of Mitsuba 3.
#pragma once

#include <string>
#include <string_view>

#include "scene/xml/diagnostics.h"
#include "scene/xml/xml_element.h"
#include "scene/xml/xml_pool.h"

namespace strahl {

/// "toWorld" -> "to_world", "cropOffsetX" -> "crop_offset_x"; other names stay.
[[nodiscard]] std::string snake_case(std::string_view name);

/// Reads the root's version and, below 2, renames all camelCase parameters and <lookAt> in place,
/// leaves the last of a parameter that is given several times, with a warning, and names the metal of conductors that
/// do not.
void upgrade_to_version_3(XmlElement& root, XmlPool& pool, Diagnostics& diagnostics);

}  // namespace strahl
