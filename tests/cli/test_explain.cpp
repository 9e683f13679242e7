// SPDX-License-Identifier: MIT
// `strahl explain`: which effects are on, why and where, and the program's name.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "program/kernel_source.h"

using namespace strahl_test;
using Json = nlohmann::json;

namespace {

Json explain(const Folder& folder, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"explain", folder.file("scene.xml", glowing_sphere), "--json", "--lanes", "8"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = folder.run(arguments);
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  return Json::parse(outcome.out);
}

Json feature(const Json& report, const std::string& name) {
  for (const Json& entry : report.at("features"))
    if (entry.at("name") == name) return entry;
  FAIL("no feature " << name);
  return {};
}

}  // namespace

TEST_CASE("every entry of every list and every flag is reported, with the element that called for it") {
  const Folder folder;
  const Json report = explain(folder, {});
  const Json sphere = feature(report, "shapes/sphere");
  CHECK(sphere.at("on") == true);
  CHECK_FALSE(sphere.at("why").get<std::string>().empty());
  CHECK(contains(sphere.at("where").get<std::string>(), "scene.xml:8"));
  CHECK(feature(report, "shapes/disk").at("on") == false);
  CHECK(feature(report, "shapes/disk").at("where").is_null());
  CHECK(feature(report, "AOV").at("on") == false);
  std::size_t expected = strahl::list_features().size();
  for (const std::string& list : strahl::list_folders()) expected += strahl::list_entries(list).size();
  CHECK(report.at("features").size() == expected);
}

TEST_CASE("options decide with the scene") {
  const Folder folder;
  CHECK(feature(explain(folder, {"--aov", "depth"}), "AOV").at("on") == true);
  CHECK(feature(explain(folder, {"--integrator", "normals"}), "integrators/normals").at("on") == true);
  const Json disabled = feature(explain(folder, {"--disable", "EMISSION"}), "EMISSION");
  CHECK(disabled.at("on") == false);
  CHECK(disabled.at("why") == "--disable");
  CHECK(feature(explain(folder, {"--generic"}), "shapes/disk").at("on") == true);
}

TEST_CASE("auto takes paths from lights only where the sampler and --pixel let them through") {
  const Folder folder;
  const auto is_on = [&](const std::string& integrator, const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"explain", STRAHL_SOURCE_DIR "/scenes/lights/beams.xml", "--json",
                                       "--integrator", "auto"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = folder.run(arguments);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return feature(Json::parse(outcome.out), "integrators/" + integrator).at("on").get<bool>();
  };
  CHECK(is_on("ptracer", {}));
  CHECK(is_on("ptracer", {"--sampler", "sobol"}));
  CHECK(is_on("path", {"--sampler", "centre"}));
  CHECK(is_on("path", {"--pixel", "3,4"}));
}

TEST_CASE("the program's name follows what is in it, and nothing else") {
  const Folder folder;
  const auto program = [&](const std::vector<std::string>& more) {
    return explain(folder, more).at("program").get<std::string>();
  };
  const std::string plain = program({});
  CHECK(plain.size() == 16);
  CHECK(program({"--width", "640", "--seed", "3"}) == plain);
  // Samples enough are followed in lanes (test_path_lanes.cpp); how many there are then does not matter.
  CHECK(program({"--spp", "300", "--seed", "3"}) == program({"--spp", "16"}));
  CHECK(program({"--integrator", "normals"}) != plain);
  CHECK(program({"--precision", "double"}) != plain);
}

TEST_CASE("the text has a line for each effect") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  const Outcome text = folder.run({"explain", "scene.xml", "--lanes", "8"});
  REQUIRE(text.code == 0);
  CHECK(contains(text.out, "\non   shapes/sphere"));
  CHECK(contains(text.out, "\noff  shapes/disk"));
  CHECK(contains(text.out, "8 lanes (--lanes)"));
}

TEST_CASE("without any device one lane is assumed, and said") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  std::filesystem::create_directory(folder.path("vendors"));
  const std::map<std::string, std::string> none{{"OCL_ICD_VENDORS", folder.path("vendors/")}};
  const Outcome text = folder.run({"explain", "scene.xml"}, none);
  CHECK(text.code == 0);
  CHECK(contains(text.out, "1 lane (no OpenCL device"));
  CHECK(folder.run({"explain", "scene.xml", "-d", "pocl"}, none).code == 4);
}

TEST_CASE("--cost takes the next word only where it is one of its own, and --among one word") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  // The device, which there is not, is looked for once the line is understood.
  for (const std::vector<std::string>& line : std::vector<std::vector<std::string>>{
           {"--cost", "scene.xml", "--json"},
           {"--cost", "scene.xml"},
           {"scene.xml", "--cost"},
           {"--cost", "effects", "scene.xml", "--json"},
           {"--cost=integrators", "scene.xml", "--json"},
           {"scene.xml", "--cost", "--json"},
           {"--cost", "--", "scene.xml"},
           {"--cost", "--among", "path", "scene.xml", "--json"},
           {"scene.xml", "--cost", "integrators", "--among", "path,direct", "--among", "bdpt"}}) {
    std::vector<std::string> arguments{"explain", "-d", "no-such-device"};
    arguments.insert(arguments.end(), line.begin(), line.end());
    const Outcome outcome = folder.run(arguments);
    INFO(outcome.err);
    CHECK(outcome.code == 4);
  }
  CHECK(folder.run({"explain", "--cost", "scene.xml", "other.xml"}).code == 2);
  CHECK(folder.run({"explain", "scene.xml", "--cost=much"}).code == 2);
}
