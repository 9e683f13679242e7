// SPDX-License-Identifier: MIT
// Primitives as the device holds them, in leaves of a tree or in plain lists (docs/decisions/0008-tree.md).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "render/settings.h"
#include "render/stats.h"

namespace strahl {

/// All primitives of one kind in the scene's order.
template <typename Real>
struct KindList {
  std::string kind;
  int planes = 0;
  std::vector<Real> values;  ///< `planes` a primitive.
  std::vector<std::int32_t> ids, parts;
};

/// One kind's blocks: planes x lanes reals and lanes ids and parts each, padded with id -1.
template <typename Real>
struct PackedKind {
  std::vector<Real> blocks;
  std::vector<std::int32_t> ids, parts;
  int listed = 0;  ///< Blocks that are not in the tree: all or none.
};

template <typename Real>
struct PackedTree {
  std::vector<PackedKind<Real>> kinds;  ///< As the lists.
  std::vector<Real> nodes;              ///< NODE_PLANES x width a node.
  std::vector<std::int32_t> children;   ///< width references a node.
  std::int32_t root;                    ///< NO_REFERENCE: none.
  std::vector<Real> reach;              ///< Centre and half the size of a box around everything bounded.
  TreeStats stats;
};

/// width: 2, 4, 8 or 16 children a node; 8 and 16 test as many primitives at a time, 2 and 4 one. The lists are used
/// up. Throws Error where a kind has more blocks than references can name. Instantiated for float and double.
template <typename Real>
[[nodiscard]] PackedTree<Real> pack_tree(std::vector<KindList<Real>> lists, int width, Acceleration acceleration);

}  // namespace strahl
