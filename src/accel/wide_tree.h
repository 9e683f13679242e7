// SPDX-License-Identifier: MIT
// A tree with up to 2, 4, 8 or 16 children a node, which tests of that many boxes at a time walk.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "accel/binary_tree.h"

namespace strahl::accel {

/// Primitives [first, first + count) of the tree's order, of one kind.
struct WideLeaf {
  std::uint32_t first, count, kind;
};

struct WideTree {
  static constexpr std::int32_t none = std::numeric_limits<std::int32_t>::min();

  int width = 2;
  std::vector<std::int32_t> children;  ///< width a node, parents before children: a node, ~leaf, or none.
  std::vector<WideLeaf> leaves;
  std::int32_t root = none;  ///< A node, ~leaf, or none where there is nothing.
  int stack_need = 0;        ///< Children that may wait at a time: width - 1 a level.

  [[nodiscard]] std::size_t nodes() const { return children.size() / static_cast<std::size_t>(width); }
};

/// What is looked for among all wide trees that keep the leaves: the fastest, or the one that needs the least stack.
enum class Aim { least_surface, least_depth };

[[nodiscard]] WideTree collapse(const BinaryTree& tree, int width, Aim aim = Aim::least_surface);

}  // namespace strahl::accel
