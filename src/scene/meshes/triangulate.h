// SPDX-License-Identifier: MIT
// Polygons of mesh files to triangles.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "scene/model/vec.h"

namespace strahl {

/// Appends the triangles of a polygon (corners in order, convex or concave, also with holes reached by a doubled
/// edge) as indices into it, oriented as the polygon; a convex polygon becomes the fan of its first corner. Every
/// corner is used, collinear ones too, so that neighbours meet without T-junctions; a corner at the position of the
/// one before it is left out.
/// Returns false and appends nothing where the polygon has no area or crosses itself.
[[nodiscard]] bool triangulate(std::span<const Vec3> polygon, std::vector<std::array<int, 3>>& triangles);

/// Unit vector along (p1 - p0) x (p2 - p0), p0 != p1 != p2 != p0. A sliver whose cross product rounds to zero gets one
/// that is perpendicular to its edge.
[[nodiscard]] Vec3 triangle_normal(const Vec3& p0, const Vec3& p1, const Vec3& p2);

}  // namespace strahl
