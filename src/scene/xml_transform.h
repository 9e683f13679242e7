// SPDX-License-Identifier: MIT
// <transform>: translate, rotate, scale, lookat and matrix in Mitsuba's order and meaning.
#pragma once

#include <optional>
#include <string>

#include "scene/diagnostics.h"
#include "scene/vec.h"
#include "scene/xml_element.h"

namespace strahl {

/// Three components from x=, y=, z= (each `missing` where absent) or from value="x, y, z" or value="s" (all three).
/// None after an error.
[[nodiscard]] std::optional<Vec3> read_components(const XmlElement& element, double missing, Diagnostics& diagnostics);

/// Each element is applied after those before it: T = new * T. None after an error.
[[nodiscard]] std::optional<Transform> read_transform(const XmlElement& element, Diagnostics& diagnostics);

/// Counter-clockwise by `degrees` around `axis` (any length > 0).
[[nodiscard]] Transform rotation(const Vec3& axis, double degrees);

/// Origin at `origin`, +z towards `target`, +y as near to `up` as can be, +x to the left. None where the view
/// direction is zero or parallel to `up`.
[[nodiscard]] std::optional<Transform> look_at(const Vec3& origin, const Vec3& target, const Vec3& up);

/// Why the linear part has no inverse in double; empty where it has one. It has none where |det| of its unit columns is
/// within rounding of 0, where the shortest column is within rounding of 0 beside the longest, or where the longest is
/// no normal number of double.
[[nodiscard]] std::string singular_because(const Transform& transform);
[[nodiscard]] inline bool is_singular(const Transform& transform) { return !singular_because(transform).empty(); }

}  // namespace strahl
