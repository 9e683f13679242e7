// SPDX-License-Identifier: MIT
// A subtree over n primitives has the 2 n - 1 nodes from its root on to itself: where a node stands depends on ranges
// alone, so threads need not agree on anything. The top is split by one range after the other, the many small ranges
// below it are taken by all threads.
#include "accel/binary_tree.h"

#include <bit>
#include <cmath>

#include "accel/sah_split.h"
#include "on_threads.h"

namespace strahl::accel {
namespace {

/// Primitives in a range that one thread takes alone.
constexpr std::uint32_t task_size = 1 << 14;

struct Range {
  std::uint32_t node;
  std::uint32_t first, last;
  int depth;
  [[nodiscard]] std::uint32_t size() const { return last - first; }
};

/// Splits ranges until they are leaves; those of at most task_size primitives are left in `tasks`, where it is given.
void build_below(BinaryTree& tree, const Range& root, const BuildOptions& options, unsigned threads,
                 std::vector<Range>* tasks) {
  std::vector<Range> open{root};
  while (!open.empty()) {
    const Range range = open.back();
    open.pop_back();
    if (tasks != nullptr && range.size() <= task_size) {
      tasks->push_back(range);
      continue;
    }
    const std::span<Primitive> primitives{tree.primitives.data() + range.first, range.size()};
    const Split split = split_range(primitives, options, range.depth, threads);
    const std::uint32_t right = split.at == 0 ? 0 : range.node + 2 * split.at;
    tree.nodes[range.node] = {range.first, range.size(), right, split.half_area};
    if (split.at == 0) continue;
    const std::uint32_t middle = range.first + split.at;
    open.push_back({right, middle, range.last, range.depth + 1});
    open.push_back({range.node + 1, range.first, middle, range.depth + 1});
  }
}

}  // namespace

Primitive::Primitive(Float4 lo, Float4 hi, std::uint32_t number, std::uint32_t kind) : box{lo, hi} {
  box.lo[3] = std::bit_cast<float>(number);
  box.hi[3] = std::bit_cast<float>(kind);
}
std::uint32_t Primitive::number() const { return std::bit_cast<std::uint32_t>(float{box.lo[3]}); }
std::uint32_t Primitive::kind() const { return std::bit_cast<std::uint32_t>(float{box.hi[3]}); }

double BinaryTree::sah_cost(int block) const {
  if (is_empty() || !(nodes[0].half_area > 0)) return 0;
  double cost = 0;
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t at = open.back();
    const BinaryNode& node = nodes[at];
    open.pop_back();
    const double share = static_cast<double>(node.half_area) / static_cast<double>(nodes[0].half_area);
    if (node.right == 0) {
      cost += share * std::ceil(node.count / static_cast<double>(block));
      continue;
    }
    cost += share;
    open.push_back(node.right);
    open.push_back(at + 1);
  }
  return cost;
}

BinaryTree build_binary_tree(std::vector<Primitive> primitives, const BuildOptions& options) {
  BinaryTree tree;
  tree.primitives = std::move(primitives);
  const auto count = static_cast<std::uint32_t>(tree.primitives.size());
  if (count == 0) return tree;
  tree.nodes = std::make_unique_for_overwrite<BinaryNode[]>(2 * std::size_t{count} - 1);
  const unsigned threads = options.threads > 0 ? options.threads : hardware_threads();

  std::vector<Range> tasks;
  build_below(tree, {0, 0, count, 0}, options, threads, &tasks);
  on_threads(tasks.size(), threads, [&](std::size_t i) { build_below(tree, tasks[i], options, 1, nullptr); });
  return tree;
}

}  // namespace strahl::accel
