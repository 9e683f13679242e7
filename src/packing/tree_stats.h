// SPDX-License-Identifier: MIT
// What --stats reports of the tree (docs/stats.md).
#pragma once

#include <cstdint>

namespace strahl {

struct TreeStats {
  double seconds = 0;            ///< To build it; filling the buffers not counted.
  double sah_cost = 0;           ///< Of the binary tree, with leaves in blocks of `lanes`; 0: there is no tree.
  std::uint64_t primitives = 0;  ///< In it.
  std::uint64_t nodes = 0, leaves = 0;
  std::uint64_t bytes = 0;  ///< Nodes and blocks, ids and parts.
};

}  // namespace strahl
