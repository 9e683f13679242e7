// SPDX-License-Identifier: MIT
// What Embree's builder makes of a scene's boxes: the yardstick for strahl's tree.
#pragma once

#include "scene/model/scene.h"

namespace strahl::bench {

struct PeerTree {
  double seconds = 0;
  double sah_cost = 0;  ///< As RunStats::tree counts: 1 a node, 1 a block of primitives.
};

/// rtcBuildBVH, binary, leaves of up to `block` primitives, which cost as much as one; high: its slower quality, which
/// splits boxes. Throws Error where Embree is not there.
[[nodiscard]] PeerTree embree_tree(const Scene& scene, bool high, unsigned threads, unsigned block);

}  // namespace strahl::bench
