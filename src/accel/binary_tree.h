// SPDX-License-Identifier: MIT
// A binary bounding volume hierarchy over boxes by the surface area heuristic.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "accel/box3.h"

namespace strahl::accel {

/// A primitive as the builder sees it: any box around it, its kind, its number in the caller's order.
struct Primitive {
  Box3 box;

  Primitive(Float4 lo, Float4 hi, std::uint32_t number, std::uint32_t kind);
  [[nodiscard]] std::uint32_t number() const;
  [[nodiscard]] std::uint32_t kind() const;
};

/// Either two children, the left one right behind its parent, or a leaf of primitives of one kind.
struct BinaryNode {
  std::uint32_t first;  ///< The primitives below: [first, first + count) of the tree's order.
  std::uint32_t count;
  std::uint32_t right;  ///< Index of the right child; 0: a leaf.
  float half_area;
};

struct BuildOptions {
  int block = 16;             ///< Primitives that a test takes at a time: costs count blocks.
  int max_leaf = 16;          ///< Primitives in a leaf at most.
  int single_kind = -1;       ///< Leaves of this kind hold one primitive; -1: there is no such kind.
  int balanced_below = 1000;  ///< Depth from which ranges are halved by number.
  unsigned threads = 0;       ///< 0: as many as the machine has. The tree is the same for any.
};

struct BinaryTree {
  std::vector<Primitive> primitives;    ///< In the order of leaves.
  std::unique_ptr<BinaryNode[]> nodes;  ///< Root at 0. Sparse: reach nodes from the root only.

  [[nodiscard]] bool is_empty() const { return primitives.empty(); }
  /// Expected cost of a random ray that meets the root: 1 a node, 1 a block of a leaf.
  [[nodiscard]] double sah_cost(int block) const;
};

/// At most 2^30 primitives. Deterministic.
[[nodiscard]] BinaryTree build_binary_tree(std::vector<Primitive> primitives, const BuildOptions& options);

}  // namespace strahl::accel
