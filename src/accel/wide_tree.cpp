// SPDX-License-Identifier: MIT
// Greedy collapse: I. Wald, C. Benthin, S. Boulos, "Getting Rid of Packets", IEEE Symposium on Interactive Ray Tracing,
// 2008.
#include "accel/wide_tree.h"

#include <algorithm>
#include <array>

namespace strahl::accel {
namespace {

constexpr std::size_t most_children = 16;

struct Children {
  std::array<std::uint32_t, most_children> node;
  std::size_t count = 0;
};

Children widest(const BinaryTree& tree, std::uint32_t at, std::size_t width, Opening opening) {
  Children children;
  children.node[children.count++] = at + 1;
  children.node[children.count++] = tree.nodes[at].right;
  while (children.count < width) {
    std::size_t largest = children.count;
    float most = -1;
    for (std::size_t i = 0; i < children.count; ++i) {
      const BinaryNode& node = tree.nodes[children.node[i]];
      const float size = opening == Opening::largest_surface ? node.half_area : static_cast<float>(node.count);
      if (node.right == 0 || !(size > most)) continue;
      most = size;
      largest = i;
    }
    if (largest == children.count) break;
    // Where the parent stood, so that neighbours stay neighbours.
    const std::uint32_t opened = children.node[largest];
    children.node[largest] = opened + 1;
    children.node[children.count++] = tree.nodes[opened].right;
  }
  return children;
}

class Collapse {
 public:
  Collapse(const BinaryTree& tree, int width, Opening opening) : tree_(tree), opening_(opening) { wide_.width = width; }

  WideTree run() {
    if (tree_.is_empty()) return std::move(wide_);
    struct Open {
      std::uint32_t node;
      std::size_t slot;  ///< Among the children, where the answer goes.
    };
    std::vector<Open> open;
    const auto width = static_cast<std::size_t>(wide_.width);
    const auto enter = [&](std::uint32_t at) {
      const BinaryNode& node = tree_.nodes[at];
      if (node.right == 0) return leaf(node);
      const auto number = static_cast<std::int32_t>(wide_.nodes());
      const std::size_t first = wide_.children.size();
      wide_.children.resize(first + width, WideTree::none);
      const Children children = widest(tree_, at, width, opening_);
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
  Opening opening_;
  WideTree wide_;
};

}  // namespace

WideTree collapse(const BinaryTree& tree, int width, Opening opening) { return Collapse(tree, width, opening).run(); }

}  // namespace strahl::accel
