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

}  // namespace

TEST_CASE("an animated shape stands where it is when the shutter opens, with a warning where it is seen to move") {
  struct Case {
    const char *open, *close;
    double x;
    const char* told;  ///< The time of the warning; null: none.
  };
  const std::string poses = pose("2", "7") + pose("-1.5f", "3") + pose("4", "5");
  for (const Case& one :
       {Case{"-3", "-1.5", 3, nullptr}, Case{"-3", "-1", 3, "-1.5 "}, Case{"2", "2", 7, nullptr},
        Case{"2", "2.5f", 7, "2"}, Case{"3", "3", 7, "2"}, Case{"4", "9", 5, nullptr}, Case{"0", "0", 3, "-1.5 "}})
    for (const bool is_old : {false, true}) {
      INFO(one.open << " to " << one.close);
      const std::string names[] = {is_old ? "shutterOpen" : "shutter_open", is_old ? "shutterClose" : "shutter_close"};
      const LoadedScene loaded =
          load_text(std::string("<scene version=\"") + (is_old ? "0.6.0" : "3.0.0") + "\">\n" +
                    moving_ball(is_old ? "toWorld" : "to_world", poses) +
                    "<sensor type=\"perspective\"><float name=\"" + names[0] + "\" value=\"" + one.open +
                    "\"/><float name=\"" + names[1] + "\" value=\"" + one.close + "\"/></sensor></scene>");
      REQUIRE(loaded.scene.shapes.size() == 1);
      CHECK(std::get<Sphere>(loaded.scene.shapes[0].geometry).center == Vec3{one.x, 0, 0});
      std::vector<std::string> told;
      for (const std::string& line : shortened(loaded.warnings))
        if (line.find("note") == std::string::npos) told.push_back(line);
      CHECK(told == (one.told == nullptr
                         ? std::vector<std::string>{}
                         : std::vector<std::string>{std::string("3:1: warning: motion is not rendered; the <transform> "
                                                                "of time ") +
                                                    one.told + " takes the place of this <animation>"}));
    }
}

TEST_CASE("a camera that has one pose never moves") {
  LoadOptions strict;
  strict.strict = true;
  const Scene scene = load_text(
                          "<scene version=\"3.0.0\"><sensor type=\"perspective\"><float name=\"shutter_close\" "
                          "value=\"1\"/><animation name=\"to_world\">" +
                              pose("0.5", "2") + "</animation></sensor></scene>",
                          strict)
                          .scene;
  CHECK(scene.camera.world_from_camera.m[0][3] == 2);
}

TEST_CASE("an animation without poses, or with poses of no time, is an error") {
  const auto told = [](const std::string& poses) { return problems(around(moving_ball("to_world", poses))); };
  const std::string none = "3:1: error: <animation> needs a <transform time=\"...\">";
  CHECK(told("") == std::vector<std::string>{none});
  CHECK(told("<transform><translate x=\"1\"/></transform>") ==
        std::vector<std::string>{none, "3:28: error: <transform> needs the attribute time"});
  for (const char* wrong : {"<translate x=\"1\"/>", "<transform time=\"soon\"/>", "<transform time=\"inf\"/>"})
    CHECK(told(wrong) == std::vector<std::string>{
                             "3:28: error: an <animation> holds a <transform time=\"...\"> for each of its times"});
}

TEST_CASE("a pose is read as any <transform>, and what it does not know is told") {
  CHECK(problems(around(moving_ball("to_world", "<transform time=\"0\"><scale value=\"0\"/></transform>"))) ==
        std::vector<std::string>{"3:48: error: a scale of 0 is singular; every factor must differ from 0"});
  CHECK(
      problems(around(moving_ball("to_world", "<transform time=\"0\" name=\"n\"><turn/></transform>"))) ==
      std::vector<std::string>{"3:28: warning: unknown attribute \"name\" of <transform> (did you mean \"time\"?); it "
                               "is ignored",
                               "3:57: warning: unknown element <turn>; it is ignored"});
  CHECK(problems(around("<animation>" + pose("0", "1") + "</animation>")) ==
        std::vector<std::string>{"2:1: error: <animation> needs the attribute name"});
}
