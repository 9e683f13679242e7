// SPDX-License-Identifier: MIT
// Groups of parameters that several materials have.
#pragma once

#include "scene/xml/properties.h"
#include "scene/xml/scene_builder.h"

namespace strahl {

/// A number > 0 or the name of a medium.
[[nodiscard]] double read_index_of_refraction(Properties& properties, const char* name, double otherwise);

/// Along which axis of a picture a view opens how wide.
struct FieldOfView {
  double degrees = 50;
  FovAxis axis = FovAxis::x;
};

/// `fov` and `fov_axis`, or `focal_length`, 50mm by default.
[[nodiscard]] FieldOfView read_field_of_view(Properties& properties);

/// Indices and shares of glass of any kind.
[[nodiscard]] Dielectric read_glass(Properties& properties, SceneBuilder& builder);

/// `material`, or `eta` and `k`.
[[nodiscard]] MetalIndex read_metal_index(Properties& properties, SceneBuilder& builder);

/// `distribution`, `alpha` or `alpha_u` and `alpha_v`, `sample_visible`.
[[nodiscard]] Microfacets read_microfacets(Properties& properties, SceneBuilder& builder);

}  // namespace strahl
