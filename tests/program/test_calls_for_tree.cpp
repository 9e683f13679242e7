// SPDX-License-Identifier: MIT
// Which scenes' programs hold a tree: the one decision that depends on how many primitives there are.
#include <catch2/catch.hpp>

#include "packing/pack_tree.h"
#include "program/program_text.h"
#include "scene/model/build.h"

using namespace strahl;

namespace {

Scene spheres(int count) {
  Scene scene;
  scene.materials.emplace_back();
  for (int i = 0; i < count; ++i) add(scene, Sphere{{3.0 * i, 0, 0}, 1});
  return scene;
}

bool calls(const Scene& scene, int width, Acceleration acceleration = Acceleration::automatic,
           const RenderSettings& settings = {}) {
  return calls_for_tree(scene, features_of(scene, settings), width, acceleration);
}

}  // namespace

TEST_CASE("Few primitives are listed, many make a tree") {
  for (const auto& [width, most] : {std::pair{16, 64}, {8, 32}, {4, 4}, {2, 4}}) {
    INFO(width);
    CHECK_FALSE(calls(spheres(most), width));
    CHECK(calls(spheres(most + 1), width));
  }
}

TEST_CASE("What is asked for holds, where there is anything to put into a tree") {
  CHECK_FALSE(calls(spheres(1000), 16, Acceleration::list));
  CHECK(calls(spheres(1), 16, Acceleration::tree));
  CHECK_FALSE(calls(spheres(0), 16, Acceleration::tree));
}

TEST_CASE("Only what a tree can hold and the program has counts") {
  Scene scene = spheres(1);
  for (int i = 0; i < 100; ++i) add(scene, Plane{{0, -1.0 * i, 0}, {0, 1, 0}});
  CHECK_FALSE(calls(scene, 16));
  RenderSettings settings;
  settings.disabled = {"shapes/sphere"};
  CHECK_FALSE(calls(scene, 16, Acceleration::tree, settings));
}

TEST_CASE("A generic program and one with instances have a tree") {
  RenderSettings settings;
  settings.generic = true;
  CHECK(calls(spheres(1), 16, Acceleration::automatic, settings));
  Scene scene = spheres(1);
  scene.groups.emplace_back().shapes = scene.shapes;
  scene.instances.emplace_back();
  CHECK(calls(scene, 16, Acceleration::list));
}

TEST_CASE("A program without a tree says so") {
  const Features features = features_of(spheres(1), {});
  const auto text = [&](bool has_tree) {
    return program_source("kernels/render.cl", features, Precision::robust, 16, 16, has_tree).text;
  };
  CHECK(text(true) != text(false));
  CHECK(text(false).find("#define HAS_TREE 0\n") != std::string::npos);
  CHECK(text(true).find("#define HAS_TREE 1\n") != std::string::npos);
}
