// SPDX-License-Identifier: MIT
// Rays as renderers ask them, to measure with: camera rays, shadow rays and diffuse bounces of a scene. Every number is
// a float, so that other programs can be asked exactly the same.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "render/intersector.h"

namespace strahl {

enum class RayKind { primary, shadow, diffuse };

inline constexpr std::array all_ray_kinds{RayKind::primary, RayKind::shadow, RayKind::diffuse};

[[nodiscard]] const char* ray_kind_name(RayKind kind);  ///< "primary", ...

struct RaySet {
  RayKind kind = RayKind::primary;
  std::vector<Ray> rays;

  [[nodiscard]] bool any_hit() const { return kind == RayKind::shadow; }
};

/// Through the middle of each pixel of the film, in squares of 16 x 16 and those in squares of 4 x 4: 16 rays in a row
/// are neighbours.
[[nodiscard]] RaySet primary_rays(const Scene& scene);

/// Shadow rays go to a point: where no light of the scene is one, adds one over the camera's right shoulder.
void add_missing_point_light(Scene& scene);

/// From where `primary` hit to the scene's first point light; one ray a hit. `hits` belongs to `primary`.
[[nodiscard]] RaySet shadow_rays(const Scene& scene, const RaySet& primary, const std::vector<Hit>& hits);

/// From there by the cosine law, as light leaves a matt surface: neighbours go different ways. Always the same.
[[nodiscard]] RaySet diffuse_rays(const RaySet& primary, const std::vector<Hit>& hits);

}  // namespace strahl
