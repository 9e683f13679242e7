// SPDX-License-Identifier: MIT
// The origin and scale of the frame in which a scene is uploaded. The shift and the power of two are applied in double,
// before anything is rounded, so that pictures depend neither on the scene's position nor on its unit of length.
#pragma once

#include "scene/model/scene.h"

namespace strahl {

struct UploadFrame {
  Vec3 origin;       ///< In the world.
  double scale = 1;  ///< Frame units per world unit, a power of two.
  /// Chosen for what is uploaded, even where it comes out as the world's own; else numbers are taken as given, because
  /// they may be exactly representable.
  bool is_chosen = false;

  [[nodiscard]] Vec3 point(const Vec3& world) const { return scale * (world - origin); }
  [[nodiscard]] Vec3 vector(const Vec3& world) const { return scale * world; }
};

/// The camera's position, and a scale at which everything visible is at most 2^13 away: products of three lengths then
/// stay within the range of fp32 for primitives down to 10^-11 of that. Where a whole shape would be smaller than that,
/// the scale is larger, but nothing more than 2^40 away: shapes of 10^-19 of the farthest one still have these
/// products.
[[nodiscard]] UploadFrame camera_frame(const Scene& scene);

}  // namespace strahl
