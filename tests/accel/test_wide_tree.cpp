// SPDX-License-Identifier: MIT
// Trees without a device: every primitive in one leaf, any number of threads, and wide nodes of the least surface,
// which small trees allow to be found by trying everything. Half a second.
#include <catch2/catch.hpp>
#include <functional>
#include <map>
#include <random>

#include "accel/binary_tree.h"
#include "accel/wide_tree.h"

namespace {

using namespace strahl::accel;

std::vector<Primitive> boxes(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(-1, 1), size(0, 0.1F);
  std::vector<Primitive> primitives;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Float4 lo{place(random), place(random), place(random), 0};
    primitives.emplace_back(lo, lo + Float4{size(random), size(random), size(random), 0}, i, i % 3);
  }
  return primitives;
}

/// The least surface of wide nodes that make of the subtree at `at` no more than `most` children; the long way.
double least_surface(const BinaryTree& tree, std::uint32_t at, int most, int width) {
  const BinaryNode& node = tree.nodes[at];
  if (node.right == 0) return 0;
  const auto split = [&](int children) {
    double least = std::numeric_limits<double>::infinity();
    for (int k = 1; k < children; ++k)
      least =
          std::min(least, least_surface(tree, at + 1, k, width) + least_surface(tree, node.right, children - k, width));
    return least;
  };
  const double as_one = static_cast<double>(node.half_area) + split(width);
  return most == 1 ? as_one : std::min(as_one, split(most));
}

/// Half the surface of a box around the leaves below each wide node, summed; how often each leaf's first primitive
/// occurs.
double surface(const BinaryTree& tree, const WideTree& wide, std::map<std::uint32_t, int>& leaves) {
  double sum = 0;
  const std::function<Box3(std::int32_t)> walk = [&](std::int32_t reference) {
    Box3 box = Box3::empty();
    if (reference < 0) {
      const WideLeaf& leaf = wide.leaves[static_cast<std::size_t>(~reference)];
      ++leaves[leaf.first];
      for (std::uint32_t i = 0; i < leaf.count; ++i) box.include(tree.primitives[leaf.first + i].box);
      return box;
    }
    const auto width = static_cast<std::size_t>(wide.width);
    for (std::size_t i = 0; i < width; ++i) {
      const std::int32_t child = wide.children[static_cast<std::size_t>(reference) * width + i];
      if (child != WideTree::none) box.include(walk(child));
    }
    sum += static_cast<double>(box.half_area());
    return box;
  };
  walk(wide.root);
  return sum;
}

}  // namespace

TEST_CASE("wide nodes have the least surface that they can have") {
  for (const int width : {2, 4, 8})
    for (unsigned seed = 0; seed < 6; ++seed) {
      BuildOptions options;
      options.block = options.max_leaf = 1;
      const BinaryTree tree = build_binary_tree(boxes(11, seed), options);
      const WideTree wide = collapse(tree, width);
      std::map<std::uint32_t, int> leaves;
      INFO("width " << width << ", seed " << seed);
      CHECK(surface(tree, wide, leaves) == Approx(least_surface(tree, 0, 1, width)).epsilon(1e-5));
      CHECK(leaves.size() == 11);
    }
}

TEST_CASE("the least deep tree needs no more stack than another") {
  for (const int width : {2, 4, 8, 16}) {
    const BinaryTree tree = build_binary_tree(boxes(5000, 3), {});
    const int least = collapse(tree, width, Aim::least_depth).stack_need;
    CHECK(least <= collapse(tree, width).stack_need);
    CHECK(least >= width - 1);
  }
}

TEST_CASE("every primitive is in one leaf, of its kind, whatever the number of threads") {
  for (const std::size_t count : {1, 2, 17, 30000}) {
    BuildOptions options;
    options.threads = 1;
    const BinaryTree one = build_binary_tree(boxes(count, 7), options);
    options.threads = 2;
    const BinaryTree two = build_binary_tree(boxes(count, 7), options);
    for (const int width : {2, 4, 8, 16}) {
      const WideTree wide = collapse(one, width), other = collapse(two, width);
      CHECK(wide.children == other.children);
      std::vector<int> met(count, 0);
      for (const WideLeaf& leaf : wide.leaves)
        for (std::uint32_t i = 0; i < leaf.count; ++i) {
          const Primitive& primitive = one.primitives[leaf.first + i];
          ++met[primitive.number()];
          CHECK(primitive.kind() == leaf.kind);
          CHECK(primitive.number() == two.primitives[leaf.first + i].number());
        }
      CHECK(met == std::vector<int>(count, 1));
    }
  }
}

TEST_CASE("centres that lie closer than any bin are sorted all the same") {
  std::vector<Primitive> flat = boxes(200, 7);
  for (Primitive& primitive : flat) primitive.box.lo[2] = primitive.box.hi[2] = 0;
  flat[17].box.hi[2] = 1e-41F;
  const WideTree wide = collapse(build_binary_tree(flat, {}), 8);
  std::size_t count = 0;
  for (const WideLeaf& leaf : wide.leaves) count += leaf.count;
  CHECK(count == 200);
}

TEST_CASE("nothing is a tree without a root") {
  const WideTree wide = collapse(build_binary_tree({}, {}), 8);
  CHECK(wide.root == WideTree::none);
  CHECK(wide.nodes() == 0);
}
