// SPDX-License-Identifier: MIT
// From the scene (double, world frame) to the three buffers of cl/scene/layout.h, rounded once, relative to a frame.
#pragma once

#include <cstdint>
#include <vector>

#include "kinds/upload_frame.h"
#include "packing/first_ids.h"
#include "packing/memory_estimate.h"
#include "packing/pack_tree.h"
#include "packing/packed_scene.h"
#include "program/features.h"
#include "scene/model/scene.h"

namespace strahl {

/// What packing depends on besides the scene.
struct PackOptions {
  int lanes = 1;
  UploadFrame frame;   ///< The camera's for render, the world for intersect and the fast tier.
  int tree_width = 0;  ///< 2 or 4 where lanes is 1 (0: 4), else lanes.
  Acceleration acceleration = Acceleration::automatic;
  MemoryNeed room{};  ///< What the buffers begin with: one that grows holds images and grids twice for a while.
};

/// Instantiated for float and double.
template <typename Real>
[[nodiscard]] PackedScene<Real> pack_scene(const Scene& scene, const Features& features, const PackOptions& options);

/// FILTER_CELLS + 1 distances in pixels from a filter's middle, from half its width down to 0: beyond the i-th lies a
/// share of (i / FILTER_CELLS)^2 on both sides together. All 0 for the centre sampler. Of kinds::drawn_filter.
[[nodiscard]] std::vector<double> filter_quantiles(const Filter& filter, SamplerKind sampler);

/// FILTER_CELLS + 1 densities per pixel of a filter along one axis, from one end to the other, and half its width: at
/// most 8 deviations of a gaussian. Of kinds::drawn_filter.
struct FilterDensities {
  double half_width = 0;
  std::vector<double> values;
};
[[nodiscard]] FilterDensities filter_densities(const Filter& filter);

}  // namespace strahl
