// SPDX-License-Identifier: MIT
// By what a scene's points choose among its lights, and which lights are none of them
// (docs/decisions/0028-many-lights.md).
#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "program/features.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

Scene scene_of(int lamps, int suns, bool has_sky, const char* integrator) {
  Scene scene;
  scene.integrator.name = integrator;
  scene.materials = {Material{}};
  add(scene, Sphere{});
  for (int i = 0; i < lamps; ++i) add(scene, PointLight{{1.0 * i, 2, 0}, {1, 1, 1}});
  for (int i = 0; i < suns; ++i) add(scene, DirectionalLight{{1.0 * i, -1, 0}, {1, 1, 1}});
  if (has_sky) add(scene, ConstantLight{});
  return scene;
}

std::set<std::string> choosers(const Scene& scene) { return features_of(scene, {}).entries.at("choosers"); }

TEST_CASE("a chooser by the number of lights and where they are") {
  using Names = std::set<std::string>;
  CHECK(choosers(scene_of(0, 0, false, "path")).empty());
  CHECK(choosers(scene_of(1, 0, false, "path")) == Names{"uniform"});
  CHECK(choosers(scene_of(0, 2, false, "path")) == Names{"power"});
  CHECK(choosers(scene_of(0, 40, false, "path")) == Names{"power"});
  CHECK(choosers(scene_of(1, 1, false, "path")) == Names{"each"});
  CHECK(choosers(scene_of(32, 0, false, "path")) == Names{"each"});
  CHECK(choosers(scene_of(33, 0, false, "path")) == Names{"tree"});
  CHECK(choosers(scene_of(3, 0, false, "ptracer")) == Names{"power"});
  CHECK(choosers(scene_of(3, 0, false, "direct")).empty());  // Takes all of them.
}

TEST_CASE("a sky that is the same from everywhere is none of them, where materials' directions find it") {
  using Names = std::set<std::string>;
  for (const char* integrator : {"path", "volpath", "direct"}) {
    INFO(integrator);
    CHECK(choosers(scene_of(0, 0, true, integrator)).empty());
  }
  CHECK(choosers(scene_of(1, 0, true, "path")) == Names{"uniform"});
  CHECK(choosers(scene_of(0, 0, true, "whitted")) == Names{"uniform"});
  CHECK(choosers(scene_of(1, 0, true, "bdpt")) == Names{"power"});
}

TEST_CASE("lights of sampling_weight 0 are none of them") {
  using Names = std::set<std::string>;
  Scene scene = scene_of(2, 0, false, "path");
  scene.lights[0].sampling_weight = 0;
  CHECK(choosers(scene) == Names{"uniform"});
  scene.lights[1].sampling_weight = 0;
  CHECK(choosers(scene).empty());
  Scene shape = scene_of(1, 0, false, "path");
  shape.shapes[0].radiance = Rgb{1, 1, 1};
  CHECK(choosers(shape) == Names{"each"});
  shape.shapes[0].sampling_weight = 0;
  CHECK(choosers(shape) == Names{"uniform"});
}

}  // namespace
}  // namespace strahl::test
