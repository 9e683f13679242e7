// SPDX-License-Identifier: MIT
// <transform>: translate, rotate, scale, lookat and matrix in Mitsuba's order and meaning.
#pragma once

#include <optional>
#include <string>

#include "scene/model/transforms.h"
#include "scene/xml/diagnostics.h"
#include "scene/xml/xml_element.h"

namespace strahl {

/// Three components from x=, y=, z= (each `missing` where absent) or from value="x, y, z" or value="s" (all three).
/// None after an error.
[[nodiscard]] std::optional<Vec3> read_components(const XmlElement& element, double missing, Diagnostics& diagnostics);

/// Of `uv` the first two coordinates alone count, and the map needs no inverse.
enum class TransformUse { space, uv };

/// Each element is applied after those before it: T = new * T. None after an error.
[[nodiscard]] std::optional<Transform> read_transform(const XmlElement& element, Diagnostics& diagnostics,
                                                      TransformUse use = TransformUse::space);

}  // namespace strahl
