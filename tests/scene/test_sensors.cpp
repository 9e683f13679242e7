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
        std::vector<std::string>{"3:1: note: the first <sensor> is used; this one is left out (--sensor side takes it)",
                                 "4:1: note: the first <sensor> is used; this one is left out (--sensor 0 takes it)"});
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
          std::vector<std::string>{"1:1: error: no <sensor> has the id or the number \"" + std::string(name) +
                                   "\"; the scene has 3, from 0 on"});
  CHECK(problems(three, with_sensor("sidee")) ==
        std::vector<std::string>{"1:1: error: no <sensor> has the id or the number \"sidee\" (did you mean \"side\"?); "
                                 "the scene has 3, from 0 on"});
  CHECK(problems("<scene version=\"3.0.0\"/>", with_sensor("0")) ==
        std::vector<std::string>{"1:1: error: no <sensor> has the id or the number \"0\"; the scene has none"});
}

TEST_CASE("a sensor that is referred to is one, and has its aliases") {
  const std::string text =
      "<scene version=\"3.0.0\"><sensor type=\"perspective\" id=\"a\"><float name=\"fov\" value=\"10\"/></sensor>"
      "<sensor type=\"perspective\" id=\"b\"><float name=\"fov\" value=\"20\"/></sensor><ref id=\"a\"/><ref id=\"b\"/>"
      "<alias id=\"b\" as=\"other\"/></scene>";
  CHECK(load_text(text).warnings.size() == 1);
  const Camera other = load_text(text, with_sensor("other")).scene.camera;
  CHECK(other.fov_degrees == 20);
  CHECK(other.number == 1);
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

TEST_CASE("a batch that cannot be shared is an error, and what it does not know is told once") {
  const auto told = [](const std::string& more) { return problems(batch_with(more), with_sensor("0")); };
  CHECK(told("<film type=\"hdrfilm\"><integer name=\"width\" value=\"13\"/></film>") ==
        std::vector<std::string>{"4:128: error: 2 sensors cannot share a film of 13 pixels' width evenly"});
  CHECK(told(film + film) ==
        std::vector<std::string>{"4:190: error: <sensor type=\"batch\"> has more than one <film>"});
  CHECK(told("<integer name=\"srf\" value=\"1\"/><ref id=\"nope\"/>") ==
        std::vector<std::string>{"4:128: warning: unknown parameter \"srf\" of <sensor type=\"batch\">; it is ignored",
                                 "4:159: error: nothing has the id \"nope\""});
  CHECK(told("<sensor type=\"batch\"/>") ==
        std::vector<std::string>{"4:128: error: a batch of sensors cannot hold another"});
  CHECK(told("<film type=\"hdrfilm\"><integer name=\"width\" value=\"12\"/><integer name=\"crop_width\" value=\"3\"/>"
             "</film>") ==
        std::vector<std::string>{"4:128: warning: the crop window of a batch's film has no effect; --crop states one"});
  CHECK(problems("<scene version=\"3.0.0\">\n<sensor type=\"batch\"/></scene>") ==
        std::vector<std::string>{"2:1: error: <sensor type=\"batch\"> needs a <sensor> inside"});
}
