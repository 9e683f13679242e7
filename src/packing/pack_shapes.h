// SPDX-License-Identifier: MIT
// One primitive after another of a shape, as its kind's block planes hold it.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "kinds/planes.h"

namespace strahl {

/// Planes that a primitive of the kind has in its block (cl/shapes/shapes.def); throws std::out_of_range.
[[nodiscard]] int planes_of(const std::string& kind);

/// The planes' own order makes normals point inwards: a cube that is mirrored keeps the order of its corners, so that a
/// mirrored scene has the same bits, and is flipped instead.
[[nodiscard]] bool faces_inward(const Geometry& geometry);

/// Calls sink once per primitive in the order of the shape's primitives.
void primitive_planes(const Geometry& geometry, const UploadFrame& frame, const PrimitiveSink& sink);

/// The nine reals that a kind's surface function calls its frame; none for kinds that have no use for one.
[[nodiscard]] std::optional<std::array<double, 9>> surface_frame(const Geometry& geometry, const UploadFrame& frame);

}  // namespace strahl
