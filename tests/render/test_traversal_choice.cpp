// SPDX-License-Identifier: MIT
// A tree where it pays, on every device, and what was asked for where something was.
#include <catch2/catch.hpp>

#include "render/stage.h"
#include "render/traversal_choice.h"

namespace strahl::test {
namespace {

TraversalChoice choice(int spheres, Acceleration acceleration = Acceleration::automatic,
                       std::optional<std::uint64_t> loop_turns = std::nullopt, int path_lanes = 1) {
  std::vector<Geometry> row;
  for (int i = 0; i < spheres; ++i) row.emplace_back(Sphere{{0.01 * i, 0, 0}, 0.004});
  const Scene scene = stage(row);
  RenderSettings settings;
  settings.loop_turns = loop_turns;
  settings.acceleration = acceleration;
  return choose_traversal(scene, features_of(scene, settings), settings, path_lanes == 1 ? Width{1, 4} : Width{16, 16},
                          path_lanes);
}

TEST_CASE("many primitives stand in a tree, also where a device ends long loops") {
  CHECK(choice(1000).has_tree);
  CHECK(choice(1000, Acceleration::automatic, 60000).has_tree);
  CHECK(choice(1000, Acceleration::automatic, 10).acceleration == Acceleration::automatic);
}

TEST_CASE("a few are listed") {
  CHECK_FALSE(choice(2).has_tree);
  CHECK(choice(2).acceleration == Acceleration::list);
}

TEST_CASE("paths in lanes meet lists of a hundred spheres or two dozen polygons") {
  CHECK_FALSE(choice(90, Acceleration::automatic, std::nullopt, 16).has_tree);
  CHECK(choice(100, Acceleration::automatic, std::nullopt, 16).has_tree);
  const auto quadrilaterals = [](int count) {
    const Scene scene = stage(std::vector<Geometry>(static_cast<std::size_t>(count), Rectangle{}));
    return choose_traversal(scene, features_of(scene, {}), {}, {16, 16}, 16).has_tree;
  };
  CHECK_FALSE(quadrilaterals(20));
  CHECK(quadrilaterals(30));
}

TEST_CASE("what a narrow tree cannot name stands in a wide one, before anything is built") {
  constexpr std::int64_t most = 1 << 24;
  const auto tree = [](std::int64_t primitives, Width width, const RenderSettings& settings = {}) {
    const Width chosen = wide_enough(width, primitives, settings);
    return std::pair(chosen.lanes, chosen.tree);
  };
  CHECK(tree(most, {1, 4}) == std::pair(1, 4));
  CHECK(tree(most + 1, {1, 4}) == std::pair(8, 8));
  CHECK(tree(most + 1, {1, 2}) == std::pair(8, 8));
  CHECK(tree(most + 1, {16, 16}) == std::pair(16, 16));
  RenderSettings named;
  named.bvh_width = 4;
  CHECK(tree(most, {1, 4}, named) == std::pair(1, 4));
  CHECK_THROWS_WITH(tree(most + 1, {1, 4}, named), Catch::Contains("state --bvh-width 8"));
  named = {};
  named.lanes = 1;
  CHECK_THROWS_WITH(tree(most + 1, {1, 4}, named), Catch::Contains("--lanes 1"));
  named.acceleration = Acceleration::list;  // Names no blocks.
  CHECK(tree(most + 1, {1, 4}, named) == std::pair(1, 4));
}

TEST_CASE("what was asked for is not changed") {
  CHECK(choice(1000, Acceleration::tree).acceleration == Acceleration::tree);
  CHECK_FALSE(choice(1000, Acceleration::list).has_tree);
}

}  // namespace
}  // namespace strahl::test
