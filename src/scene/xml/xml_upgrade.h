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

/// Of the version that a file's root states; a root that is no <scene> may state none and has the includer's.
[[nodiscard]] int major_version(const XmlElement& root, int inherited, Diagnostics& diagnostics);
[[nodiscard]] constexpr bool is_of_0x(int major) { return major < 2; }

/// In 0.x a bsdf of an OBJ has the name of one of the file's materials, which stays as it is.
[[nodiscard]] bool has_own_name(const XmlElement& element, const XmlElement* parent);

/// Of one file, in place, once its $names and includes are replaced, so that every type is known; what was included
/// stays, as it has a version of its own. parent: where the file is included; null of the main file. Of any version
/// <lookAt> is renamed. Below 2 so are all camelCase parameters, the last of a parameter that is given several times is
/// left, with a warning, and the other rules that differ are written into the elements.
void upgrade_to_version_3(XmlElement& root, const XmlElement* parent, int major, XmlPool& pool,
                          Diagnostics& diagnostics);

}  // namespace strahl
