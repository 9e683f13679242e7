// SPDX-License-Identifier: MIT
// Primitives as the device holds them, in leaves of a tree or in plain lists (docs/decisions/0008-tree.md).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "packing/primitive_bounds.h"
#include "packing/tree_stats.h"
#include "program/features.h"
#include "settings/settings.h"

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
  int stack_need = 0;                   ///< References that may wait at a time.
  bool lists_instances = false;         ///< They are not in the tree: all or none.
  std::vector<Bounds<Real>> outline;    ///< Around the bounded primitives; empty where none was asked for.
  TreeStats stats;

  /// `reach`, rounded outwards.
  [[nodiscard]] Bounds<Real> box() const;
};

/// Of a kind, that references can name: a tree of fewer than 8 children a node has a block for each primitive.
inline constexpr std::int64_t most_blocks = std::int64_t{1} << 24;

struct TreeOptions {
  int width = 16;  ///< 2, 4, 8 or 16 children a node; 8 and 16 test as many primitives at a time, 2 and 4 one.
  Acceleration acceleration = Acceleration::automatic;
  int stack = 0;            ///< References that may wait at a time.
  std::size_t outline = 0;  ///< Boxes of PackedTree::outline, about (packing/outline.h); 0: none.
};

/// Whether a program for the scene needs more than lists; where not, it is to be packed with Acceleration::list.
/// width: as TreeOptions has it.
[[nodiscard]] bool calls_for_tree(const Scene& scene, const Features& features, int width, Acceleration acceleration);

/// What the kernels' stack holds (cl/scene/layout.h).
[[nodiscard]] int stack_entries(int width);

/// The lists are used up. instances: boxes around them; they count as a kind of their own, after all lists. Throws
/// Error where a kind has more blocks than references can name. Instantiated for float and double.
template <typename Real>
[[nodiscard]] PackedTree<Real> pack_tree(std::vector<KindList<Real>> lists, const std::vector<Bounds<Real>>& instances,
                                         const TreeOptions& options);

/// Where a group's tree has gone.
struct AppendedTree {
  std::int32_t root = 0;                            ///< As PackedTree has it.
  std::vector<std::array<std::int32_t, 2>> listed;  ///< For every kind its first block and how many are listed.
};

/// Nodes and blocks of a tree over the same kinds, behind those that are there.
template <typename Real>
[[nodiscard]] AppendedTree append_tree(PackedTree<Real>& all, const PackedTree<Real>& group, int width);

}  // namespace strahl
