// SPDX-License-Identifier: MIT
// Transforms that scenes are built with.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>

#include "scene/model/vec.h"

namespace strahl {

/// Sine and cosine; quarter turns come out exact, so that a scene turned by 90 degrees stays axis-aligned.
[[nodiscard]] std::pair<double, double> sin_cos_degrees(double degrees);

/// Counter-clockwise by `degrees` around `axis` (any length > 0).
[[nodiscard]] Transform rotation(const Vec3& axis, double degrees);

/// Origin at `origin`, +z towards `target`, +y as near to `up` as can be, +x to the left. None where the view
/// direction is zero or parallel to `up`.
[[nodiscard]] std::optional<Transform> look_at(const Vec3& origin, const Vec3& target, const Vec3& up);

/// The largest factor by which the linear part lengthens a vector: its largest singular value.
[[nodiscard]] double largest_stretch(const Transform& transform);

/// The columns of the linear part over the cube root of |det|: a rotation's axes where all axes are scaled alike.
[[nodiscard]] std::array<Vec3, 3> unscaled_columns(const Transform& transform);

/// The perpendicular unit axes that are nearest to these, of either handedness: the orthogonal factor of their polar
/// decomposition. None where these are not perpendicular and of length 1 to 10^-3; files write rotations with four
/// digits.
[[nodiscard]] std::optional<std::array<Vec3, 3>> nearest_axes(const std::array<Vec3, 3>& axes);

/// Why the linear part has no inverse in double; empty where it has one. It has none where |det| of its unit columns is
/// within rounding of 0, where the shortest column is within rounding of 0 beside the longest, or where the longest is
/// no normal number of double.
[[nodiscard]] std::string singular_because(const Transform& transform);
[[nodiscard]] inline bool is_singular(const Transform& transform) { return !singular_because(transform).empty(); }

}  // namespace strahl
