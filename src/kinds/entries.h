// SPDX-License-Identifier: MIT
// The entry of cl's lists (shapes.def, lights.def ...) that computes an element of a scene.
#pragma once

#include <string>

#include "scene/model/scene.h"

namespace strahl {

/// Rectangle and cube are "parallelogram", a mesh "triangle".
[[nodiscard]] std::string shape_kind(const Shape& shape);
/// The entry that draws places on such a shape; empty where there is none because the area is infinite.
[[nodiscard]] std::string area_kind(const Geometry& geometry);
[[nodiscard]] std::string light_kind(const Light& light);
[[nodiscard]] std::string texture_kind(const Texture& texture);
[[nodiscard]] std::string medium_entry(const Medium& medium);
[[nodiscard]] std::string phase_entry(PhaseFunction::Kind kind);
[[nodiscard]] std::string sampler_entry(SamplerKind kind);

}  // namespace strahl
