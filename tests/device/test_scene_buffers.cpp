// SPDX-License-Identifier: MIT
// What an upload refuses before it copies anything.
#include <catch2/catch.hpp>

#include "device/scene_buffers.h"
#include "scene/build.h"
#include "support/devices.h"

using namespace strahl;

TEST_CASE("instances are refused at their place until they are rendered") {
  Scene scene;
  Group group;
  group.shapes.emplace_back().geometry = Sphere{};
  add_instance(scene, add(scene, group), {});
  scene.instances[0].where = {"scene.xml", 7, 3};
  const Device device = Device::open("pocl");
  try {
    static_cast<void>(upload_scene(device, scene, features_of(scene, {}), Precision::robust, {1, Vec3{}}));
    FAIL("no error");
  } catch (const SceneError& error) {
    REQUIRE(error.diagnostics().size() == 1);
    CHECK(error.diagnostics()[0].text().find("scene.xml:7:3: error: instances are read but not rendered yet") == 0);
  }
}
