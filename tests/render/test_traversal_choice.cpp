// SPDX-License-Identifier: MIT
// A tree where it pays, lists where a device might end the tree's loops before a ray is through.
#include <catch2/catch.hpp>

#include "render/stage.h"
#include "render/traversal_choice.h"

namespace strahl::test {
namespace {

Scene row_of_spheres(int count) {
  std::vector<Geometry> spheres;
  for (int i = 0; i < count; ++i) spheres.emplace_back(Sphere{{0.01 * i, 0, 0}, 0.004});
  return stage(spheres);
}

TraversalChoice choice(const Scene& scene, std::optional<std::uint64_t> loop_turns,
                       Acceleration acceleration = Acceleration::automatic) {
  RenderSettings settings;
  settings.loop_turns = loop_turns;
  settings.acceleration = acceleration;
  return choose_traversal(scene, features_of(scene, settings), settings, {1, 4}, intersect_loops);
}

TEST_CASE("the tree is left for lists only where its loops might not end in time") {
  const Scene scene = row_of_spheres(1000);
  const TraversalChoice free = choice(scene, std::nullopt);
  REQUIRE(free.has_tree);
  const auto enough = static_cast<std::uint64_t>(free.loops.launch + free.loops.sample + 1);
  CHECK(choice(scene, enough).has_tree);
  const TraversalChoice lists = choice(scene, enough - 2);
  CHECK_FALSE(lists.has_tree);
  CHECK(lists.acceleration == Acceleration::list);
  CHECK(lists.loops.sample < free.loops.sample);
}

TEST_CASE("what was asked for is not changed, however few turns there are") {
  const Scene scene = row_of_spheres(1000);
  CHECK(choice(scene, 10, Acceleration::tree).has_tree);
  CHECK_FALSE(choice(scene, std::nullopt, Acceleration::list).has_tree);
}

TEST_CASE("a few primitives are listed, and their turns counted as such") {
  const TraversalChoice few = choice(row_of_spheres(2), 60000);
  CHECK_FALSE(few.has_tree);
  CHECK(few.loops.sample == intersect_loops(row_of_spheres(2), 1, Acceleration::list).sample);
}

}  // namespace
}  // namespace strahl::test
