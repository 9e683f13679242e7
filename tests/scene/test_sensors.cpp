// SPDX-License-Identifier: MIT
// Which of several <sensor>s is the camera.
#include <catch2/catch.hpp>

#include "scene/scene_text.h"

using namespace strahl;
using namespace strahl::test;

namespace {

LoadOptions with_sensor(const std::string& name) {
  LoadOptions options;
  options.sensor = name;
  return options;
}

const std::string film = "<film type=\"hdrfilm\"><integer name=\"width\" value=\"12\"/></film>";
const std::string three =
    "<scene version=\"3.0.0\">\n"
    "<sensor type=\"perspective\"><float name=\"fov\" value=\"10\"/></sensor>\n"
    "<sensor type=\"perspective\" id=\"side\"><float name=\"fov\" value=\"20\"/></sensor>\n"
    "<sensor type=\"perspective\" id=\"0\"><float name=\"fov\" value=\"30\"/></sensor></scene>\n";

std::string batch_with(const std::string& more) {
  return "<scene version=\"3.0.0\">\n<sensor type=\"batch\">\n<sensor type=\"orthographic\" id=\"left\"/>\n"
         "<sensor type=\"perspective\"><float name=\"fov\" value=\"20\"/><film type=\"hdrfilm\">"
         "<integer name=\"width\" value=\"7\"/></film></sensor>" +
         more + "</sensor></scene>\n";
}

}  // namespace

TEST_CASE("of several sensors the first is used, and the others are told") {
  const LoadedScene loaded = load_text(three);
  CHECK(loaded.scene.camera.fov_degrees == 10);
  CHECK(shortened(loaded.warnings) ==
        std::vector<std::string>{"3:1: note: the first <sensor> is used; this one is left out (--sensor 1 takes it)",
                                 "4:1: note: the first <sensor> is used; this one is left out (--sensor 2 takes it)"});
}

TEST_CASE("a sensor is chosen by its id, else by its number, without a word of the others") {
  const auto fov = [](const std::string& name) {
    const LoadedScene loaded = load_text(three, with_sensor(name));
    CHECK(loaded.warnings.empty());
    return loaded.scene.camera.fov_degrees;
  };
  CHECK(fov("1") == 20);
  CHECK(fov("side") == 20);
  CHECK(fov("2") == 30);
  CHECK(fov("0") == 30);  // An id.
}

TEST_CASE("a sensor that is not there is an error") {
  for (const char* name : {"3", "-1", "1x", "+1", " 1"})
    CHECK(problems(three, with_sensor(name)) ==
          std::vector<std::string>{"1:1: error: no <sensor> is \"" + std::string(name) +
                                   "\"; the scene has 3, counted from 0"});
  CHECK(problems(three, with_sensor("sidee")) ==
        std::vector<std::string>{
            "1:1: error: no <sensor> is \"sidee\" (did you mean \"side\"?); the scene has 3, counted from 0"});
  CHECK(problems("<scene version=\"3.0.0\"/>", with_sensor("0")) ==
        std::vector<std::string>{"1:1: error: no <sensor> is \"0\"; the scene has 0, counted from 0"});
}

TEST_CASE("a mesh has no sensor to choose") {
  const SceneFolder folder;
  const std::string mesh = folder.write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const LoadedScene loaded = load_scene(mesh, with_sensor("1"));
  REQUIRE(loaded.warnings.size() == 1);
  CHECK(loaded.warnings[0].message == "--sensor 1: a mesh has no <sensor>; it has no effect");
}

TEST_CASE("sensors of a batch are sensors, and share its film's width") {
  const LoadedScene first = load_text(batch_with(film));
  CHECK(first.scene.camera.projection == Projection::orthographic);
  CHECK(first.scene.film.width == 6);
  CHECK(
      shortened(first.warnings) ==
      std::vector<std::string>{"4:1: warning: the first <sensor> is used; this one is left out (--sensor 1 takes it)"});
  const LoadedScene second = load_text(batch_with(film), with_sensor("1"));
  CHECK(second.warnings.empty());
  CHECK(second.scene.camera.fov_degrees == 20);
  CHECK(second.scene.film.width == 6);
  CHECK(load_text(batch_with(""), with_sensor("1")).scene.film.width == 7);  // Without one it has its own.
}

TEST_CASE("a batch that cannot be shared is an error") {
  CHECK(
      problems(batch_with("<film type=\"hdrfilm\"><integer name=\"width\" value=\"13\"/></film>"), with_sensor("0")) ==
      std::vector<std::string>{"4:128: error: 2 sensors cannot share a film of 13 pixels' width evenly"});
  CHECK(problems("<scene version=\"3.0.0\">\n<sensor type=\"batch\"/></scene>") ==
        std::vector<std::string>{"2:1: error: <sensor type=\"batch\"> needs a <sensor> inside"});
}
