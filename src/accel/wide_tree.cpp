// SPDX-License-Identifier: MIT
// Of all ways to make wide nodes of a binary tree's the one whose nodes have the least surface, or that is the least
// deep, by dynamic programming:
// H. Ylitie, T. Karras, S. Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs", High
// Performance Graphics, 2017.
#include "accel/wide_tree.h"

#include <algorithm>
#include <array>

namespace strahl::accel {
namespace {

constexpr std::size_t most_children = 16;

/// The binary tree's nodes without gaps, parents before children, the left child right behind its parent.
struct DenseTree {
  struct Node {
    std::uint32_t at;     ///< In the binary tree.
    std::uint32_t right;  ///< 0: a leaf.
  };
  std::vector<Node> nodes;

  explicit DenseTree(const BinaryTree& tree) {
    struct Open {
      std::uint32_t at, parent;
      bool is_right;
    };
    std::vector<Open> open = {{0, 0, false}};
    while (!open.empty()) {
      const Open next = open.back();
      open.pop_back();
      const auto number = static_cast<std::uint32_t>(nodes.size());
      nodes.push_back({next.at, 0});
      if (next.is_right) nodes[next.parent].right = number;
      const std::uint32_t right = tree.nodes[next.at].right;
      if (right == 0) continue;
      open.push_back({right, number, true});
      open.push_back({next.at + 1, number, false});
    }
  }
};

/// How the subtree below a node is best made into at most j children of a wide node, for every j up to the width.
class Forests {
 public:
  Forests(const BinaryTree& tree, const DenseTree& dense, std::size_t width, Aim aim)
      : width_(width), aim_(aim), left_share_(dense.nodes.size() * width, 0) {
    std::vector<float> cost(dense.nodes.size() * width, 0);
    for (std::size_t node = dense.nodes.size(); node-- > 0;) {
      if (dense.nodes[node].right == 0) continue;
      const float* left = &cost[(node + 1) * width];
      const float* right = &cost[dense.nodes[node].right * width];
      float* mine = &cost[node * width];
      for (std::size_t j = 2; j <= width; ++j) split(left, right, j, mine[j - 1], left_share_[node * width + j - 1]);
      // As one child it is a wide node itself; leaves cost the same everywhere.
      mine[0] = mine[width - 1] + (aim == Aim::least_surface ? tree.nodes[dense.nodes[node].at].half_area : 1.0F);
      for (std::size_t j = 2; j < width; ++j) {
        if (!(mine[0] < mine[j - 1])) continue;
        mine[j - 1] = mine[0];
        left_share_[node * width + j - 1] = 0;
      }
    }
  }

  /// Of j children that a node becomes those for its left child; 0: it becomes one.
  [[nodiscard]] std::size_t left_share(std::size_t node, std::size_t j) const {
    return left_share_[node * width_ + j - 1];
  }

 private:
  void split(const float* left, const float* right, std::size_t j, float& least, std::uint8_t& share) const {
    least = together(left[0], right[j - 2]);
    share = 1;
    for (std::size_t k = 2; k < j; ++k) {
      const float cost = together(left[k - 1], right[j - k - 1]);
      if (!(cost < least)) continue;
      least = cost;
      share = static_cast<std::uint8_t>(k);
    }
  }

  [[nodiscard]] float together(float left, float right) const {
    return aim_ == Aim::least_surface ? left + right : std::max(left, right);
  }

  std::size_t width_;
  Aim aim_;
  std::vector<std::uint8_t> left_share_;
};

class Collapse {
 public:
  Collapse(const BinaryTree& tree, int width, Aim aim)
      : tree_(tree), dense_(tree), forests_(tree, dense_, static_cast<std::size_t>(width), aim) {
    wide_.width = width;
  }

  WideTree run() {
    struct Open {
      std::uint32_t node;
      std::size_t slot;  ///< Among the children, where the answer goes.
    };
    std::vector<Open> open;
    const auto width = static_cast<std::size_t>(wide_.width);
    const auto enter = [&](std::uint32_t node) {
      const BinaryNode& binary = tree_.nodes[dense_.nodes[node].at];
      if (binary.right == 0) return leaf(binary);
      const auto number = static_cast<std::int32_t>(wide_.nodes());
      const std::size_t first = wide_.children.size();
      wide_.children.resize(first + width, WideTree::none);
      const Children children = children_of(node);
      for (std::size_t i = children.count; i-- > 0;) open.push_back({children.node[i], first + i});
      return number;
    };
    wide_.root = enter(0);
    while (!open.empty()) {
      const Open next = open.back();
      open.pop_back();
      const std::int32_t reference = enter(next.node);
      wide_.children[next.slot] = reference;
    }
    measure_stack();
    return std::move(wide_);
  }

 private:
  struct Children {
    std::array<std::uint32_t, most_children> node;
    std::size_t count = 0;
  };

  [[nodiscard]] Children children_of(std::uint32_t parent) const {
    Children children;
    const auto width = static_cast<std::size_t>(wide_.width);
    const std::size_t left = forests_.left_share(parent, width);
    gather(parent + 1, left, children);
    gather(dense_.nodes[parent].right, width - left, children);
    return children;
  }

  void gather(std::uint32_t node, std::size_t most, Children& children) const {
    const std::size_t left = forests_.left_share(node, most);
    if (left == 0) {
      children.node[children.count++] = node;
      return;
    }
    gather(node + 1, left, children);
    gather(dense_.nodes[node].right, most - left, children);
  }

  std::int32_t leaf(const BinaryNode& node) {
    wide_.leaves.push_back({node.first, node.count, tree_.primitives[node.first].kind()});
    return ~static_cast<std::int32_t>(wide_.leaves.size() - 1);
  }

  void measure_stack() {
    const auto width = static_cast<std::size_t>(wide_.width);
    std::vector<int> need(wide_.nodes(), 0);
    for (std::size_t node = need.size(); node-- > 0;) {
      int deepest = 0;
      for (std::size_t i = 0; i < width; ++i) {
        const std::int32_t child = wide_.children[node * width + i];
        if (child >= 0) deepest = std::max(deepest, need[static_cast<std::size_t>(child)]);
      }
      need[node] = wide_.width - 1 + deepest;
    }
    if (!need.empty()) wide_.stack_need = need[0];
  }

  const BinaryTree& tree_;
  DenseTree dense_;
  Forests forests_;
  WideTree wide_;
};

}  // namespace

WideTree collapse(const BinaryTree& tree, int width, Aim aim) {
  if (!tree.is_empty()) return Collapse(tree, width, aim).run();
  WideTree wide;
  wide.width = width;
  return wide;
}

}  // namespace strahl::accel
