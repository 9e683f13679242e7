// SPDX-License-Identifier: MIT
// `strahl bench` on a device: the table, the JSON, the comparison. 2 s.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/program.h"

using namespace strahl_test;
using nlohmann::json;

TEST_CASE("a table, JSON, and both beside an earlier run") {
  const Folder folder;
  const Outcome outcome = folder.run({"bench", "-d", "pocl", "--scene", "ten", "--pixels", "64", "--json", "a.json"});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(contains(outcome.out, "ten, 11 primitives"));
  CHECK(contains(outcome.out, "diffuse"));
  CHECK(contains(outcome.out, "read, GB/s"));
  CHECK_FALSE(contains(outcome.out, "times as fast as"));
  json first = json::parse(read_text(folder.path("a.json")));
  for (const std::string kind : {"primary", "shadow", "diffuse"}) {
    CHECK(first["rays"][kind] > 1000);
    for (const std::string tier : {"fast", "stable", "robust", "double"}) CHECK(first["mrays"][kind][tier] > 0);
  }
  CHECK(first["bandwidth"]["read"] > 0);
  CHECK(first["bandwidth"]["copy"] > 0);
  CHECK(first["program_seconds"].size() == 4);
  CHECK(first["program_from_cache"].size() == 4);

  for (auto& [kind, tiers] : first["mrays"].items())
    for (auto& [tier, value] : tiers.items()) value = value.get<double>() / 1000;
  folder.file("base.json", first.dump());
  const Outcome shown =
      folder.run({"bench", "-d", "pocl", "--scene", "ten", "--compare", "base.json", "--json", "b.json"});
  CHECK(contains(shown.out, "times as fast as"));
  // Whatever the second run measured, the ratios are of what it says it did.
  const json second = json::parse(read_text(folder.path("b.json")));
  CHECK(second["rays"] == first["rays"]);  // As many as the earlier run, unasked.
  for (const std::string kind : {"primary", "shadow", "diffuse"})
    for (const std::string tier : {"fast", "stable", "robust", "double"}) {
      const double ratio = second["mrays"][kind][tier].get<double>() / first["mrays"][kind][tier].get<double>();
      CHECK(contains(shown.out, fmt::format(" x{:.2f}", ratio)));
    }
}

TEST_CASE("the width that was measured best is used from then on", "[slow]") {
  const Folder folder;
  const std::map<std::string, std::string> cache{{"STRAHL_CACHE_DIR", folder.path("cache")}};
  const auto program = [&](std::vector<std::string> more) {
    folder.file("scene.xml", glowing_sphere);
    std::vector<std::string> arguments{"explain", "scene.xml", "--json", "-d", "pocl", "--precision", "stable"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return json::parse(folder.run(arguments, cache).out)["program"];
  };
  CHECK(folder.run({"bench", "--tune", "--json", "a.json"}).code == 2);
  const Outcome tuned = folder.run({"bench", "--tune", "-d", "pocl", "--scene", "tetra-4", "--pixels", "32"}, cache);
  INFO(tuned.out << tuned.err);
  REQUIRE(tuned.code == 0);
  const std::size_t row = tuned.out.find("stable"), star = tuned.out.find('*', row);
  REQUIRE(star != std::string::npos);
  const std::size_t colon = tuned.out.rfind(':', star), blank = tuned.out.rfind(' ', colon);
  const std::string best = tuned.out.substr(blank + 1, colon - blank - 1);
  CHECK(program({}) == program({"--bvh-width", best}));
  const std::string other = best == "4" ? "8" : "4";
  CHECK(program({}) != program({"--bvh-width", other}));

  // A width that cannot be remembered is told all the same.
  int remembered = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path("cache")))
    if (entry.path().filename().string().starts_with("tuned-width-")) {
      ++remembered;
      std::filesystem::remove(entry.path());
      std::filesystem::create_directories(entry.path() / "in the way");
    }
  CHECK(remembered > 0);
  const Outcome again = folder.run({"bench", "--tune", "-d", "pocl", "--scene", "tetra-4", "--pixels", "32"}, cache);
  INFO(again.out << again.err);
  CHECK(again.code == 1);
  CHECK(contains(again.out, "*"));
  CHECK_FALSE(contains(again.out, "remembered"));
  CHECK(contains(again.err, "widths are not remembered"));
  CHECK(contains(again.err, "STRAHL_CACHE_DIR"));
}

TEST_CASE("what cannot be compared is said before anything is measured") {
  const Folder folder;
  folder.file("text.json", "{\"device\": 1}");
  CHECK(folder.run({"bench", "--compare", "text.json"}).code == 3);
  const auto against = [&](const std::string& scene, int primitives, int rays) {
    const json base{{"device", "a"}, {"scene", scene}, {"primitives", primitives}, {"rays", {{"primary", rays}}}};
    folder.file("other.json", base.dump());
    const Outcome outcome = folder.run({"bench", "--scene", "ten", "--pixels", "64", "--compare", "other.json"});
    CHECK(outcome.code == 3);
    return outcome.err;
  };
  CHECK(contains(against("sphereflake-5", 11, 4096), "--scene sphereflake-5"));
  CHECK(contains(against("lit", 11, 4096), "(--scene with its file)"));
  CHECK(contains(against("ten", 12, 4096), "another scene called ten, with 12 primitives, and this one has 11"));
  CHECK(contains(against("ten", 11, 1024), "32 x 32 camera rays; only as many compare"));
  for (const int none : {-4096, 0, 4095, 2000000000}) CHECK(contains(against("ten", 11, none), "camera rays"));
  CHECK(folder.run({"bench", "--scene", "ten", "--json", "-", "--compare", "none.json"}).code == 3);
  CHECK(folder.run({"bench", "--scene", "teapot"}).code == 2);
  CHECK(folder.run({"bench", "--scene", "missing.ply"}).code == 3);
  CHECK(folder.run({"bench", "--json", "nowhere/a.json"}).code == 1);
}

TEST_CASE(
    "a scene whose lights are no points gets a lamp for its shadow rays; its warnings are told, a name that is no "
    "UTF-8 too") {
  const Folder folder;
  const std::string room = "r\xfcm.xml";  // ISO 8859-1
  std::string text = read_text(STRAHL_SOURCE_DIR "/scenes/cornell/cornell-box.xml");
  folder.file(
      room, text.insert(text.rfind("</scene>"), "<shape type=\"sphere\"><float name=\"raduis\" value=\"2\"/></shape>"));
  const Outcome outcome = folder.run({"bench", "-d", "pocl", "--scene", room, "--pixels", "32", "--json", "a.json"});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(contains(outcome.err, "warning: "));
  CHECK(contains(outcome.err, "raduis"));
  const json numbers = json::parse(read_text(folder.path("a.json")));
  CHECK(numbers["rays"]["shadow"] > 100);
  CHECK(numbers["scene"] == "r\uFFFDm");
}

TEST_CASE("programs that were built are told from those that were loaded, and not compared") {
  const Folder folder;
  const std::map<std::string, std::string> cache{{"STRAHL_CACHE_DIR", folder.path("cache")}};
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"bench", "-d", "pocl", "--scene", "ten", "--pixels", "16"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = folder.run(arguments, cache);
    INFO(outcome.err);
    REQUIRE(outcome.code == 0);
    return outcome.out;
  };
  const auto line = [](const std::string& text, const std::string& name) {
    const std::size_t first = text.find("\n" + name);
    REQUIRE(first != std::string::npos);
    return text.substr(first, text.find('\n', first + 1) - first);
  };
  CHECK(contains(run({"--json", "built.json"}), "built     built     built     built"));
  CHECK(json::parse(read_text(folder.path("built.json")))["program_from_cache"]["robust"] == false);
  const std::string against_built = run({"--json", "loaded.json", "--compare", "built.json"});
  CHECK(contains(against_built, "loaded"));
  CHECK_FALSE(contains(line(against_built, "program, s"), "x"));
  CHECK(contains(line(against_built, "primary"), " x"));
  CHECK(json::parse(read_text(folder.path("loaded.json")))["program_from_cache"]["robust"] == true);
  CHECK(contains(line(run({"--compare", "loaded.json"}), "program, s"), "x"));
}
