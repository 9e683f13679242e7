// SPDX-License-Identifier: MIT
// <animation> of Mitsuba 0.x: the pose of its earliest time.
#include <catch2/catch.hpp>

#include "scene/scene_text.h"

using namespace strahl;
using namespace strahl::test;

namespace {

std::string moving_ball(const std::string& name, const std::string& poses) {
  return "<shape type=\"sphere\">\n<animation name=\"" + name + "\">" + poses + "</animation></shape>";
}

std::string pose(const std::string& time, const std::string& x) {
  return "<transform time=\"" + time + "\"><translate x=\"" + x + "\"/></transform>";
}

std::string older(const std::string& body) {
  return "<scene version=\"0.6.0\">\n" + body + "\n<sensor type=\"perspective\"/></scene>\n";
}

}  // namespace

TEST_CASE("an animated shape stands where its earliest time has it, with a warning where it would be seen to move") {
  for (const bool is_old : {false, true}) {
    const std::string poses = pose("2", "7") + pose("-1.5", "3") + pose("4", "5");
    const LoadedScene loaded =
        load_text(is_old ? older(moving_ball("toWorld", poses)) : around(moving_ball("to_world", poses)));
    REQUIRE(loaded.scene.shapes.size() == 1);
    CHECK(std::get<Sphere>(loaded.scene.shapes[0].geometry).center == Vec3{3, 0, 0});
    CHECK(shortened(loaded.warnings) ==
          std::vector<std::string>{"3:1: warning: motion is not rendered; the <transform> of time -1.5 takes the place "
                                   "of this <animation>"});
  }
}

TEST_CASE("a camera that moves stays where it begins, which is all that a shutter sees that closes by then") {
  const auto load = [](const std::string& shutter) {
    return load_text("<scene version=\"0.6.0\">\n<sensor type=\"perspective\">" + shutter +
                     "<animation name=\"toWorld\">" + pose("0.5", "2") + pose("1", "9") +
                     "</animation></sensor></scene>");
  };
  for (const char* shutter : {"", "<float name=\"shutterClose\" value=\"0.5\"/>"}) {
    const LoadedScene loaded = load(shutter);
    CHECK(loaded.warnings.empty());
    CHECK(loaded.scene.camera.world_from_camera.m[0][3] == 2);
  }
  const LoadedScene loaded = load("<float name=\"shutterClose\" value=\"0.6\"/>");
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.scene.camera.world_from_camera.m[0][3] == 2);
}

TEST_CASE("an animation without poses, or with poses of no time, is an error") {
  CHECK(problems(around(moving_ball("to_world", ""))) ==
        std::vector<std::string>{"3:1: error: <animation> needs a <transform time=\"...\">"});
  for (const char* wrong : {"<transform><translate x=\"1\"/></transform>", "<translate x=\"1\"/>",
                            "<transform time=\"soon\"/>", "<transform time=\"inf\"/>"})
    CHECK(
        problems(around(moving_ball("to_world", wrong))) ==
        std::vector<std::string>{"3:28: error: an <animation> holds a <transform time=\"...\"> for each of its times"});
}

TEST_CASE("a pose is read as any <transform>") {
  CHECK(problems(around(moving_ball("to_world", "<transform time=\"0\"><scale value=\"0\"/></transform>"))) ==
        std::vector<std::string>{"3:48: error: a scale of 0 is singular; every factor must differ from 0"});
  CHECK(problems(around("<animation>" + pose("0", "1") + "</animation>")) ==
        std::vector<std::string>{"2:1: error: <transform> needs the attribute name"});
}
