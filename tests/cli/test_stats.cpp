// SPDX-License-Identifier: MIT
// --stats of a render: every documented key, sums that add up, counts from the second render only.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "cli/program.h"

using namespace strahl_test;
using Json = nlohmann::json;

namespace {

Json stats(const Folder& folder, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"render", folder.file("scene.xml", glowing_sphere), "-q", "--stats", "stats.json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = folder.run(arguments);
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  return Json::parse(read_text(folder.path("stats.json")));
}

}  // namespace

TEST_CASE("the statistics have every documented key") {
  const Folder folder;
  const Json json = stats(folder, {"--spp", "2", "--seed", "5"});
  const std::string documentation = read_text(STRAHL_SOURCE_DIR "/docs/stats.md");
  for (const auto& [key, value] : json.items()) {
    INFO(key);
    CHECK(contains(documentation, "`" + key + "`"));
  }
  // And every one of the page's first table.
  std::istringstream lines(documentation.substr(0, documentation.find("\n## ")));
  int documented = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("| `")) continue;
    std::istringstream names(line.substr(2, line.find(" |", 2) - 2));
    for (std::string name; std::getline(names, name, ',');) {
      const std::size_t begin = name.find('`') + 1;
      const std::string key = name.substr(begin, name.find('`', begin) - begin);
      INFO(key);
      if (key == "detail") continue;  // Only with --stats-detail.
      ++documented;
      CHECK(json.contains(key));
    }
  }
  CHECK(documented > 30);
  double sum = 0;
  for (const char* phase : {"start", "device", "load", "bvh", "program", "upload", "kernel", "readback", "error",
                            "encode", "exit", "other"}) {
    const double seconds = json.at("seconds").at(phase);
    CHECK(seconds >= 0);
    sum += seconds;
  }
  CHECK(json.at("seconds").at("total").get<double>() == Approx(sum).margin(1e-3));
  REQUIRE(json.at("kernel_runs").size() >= 1);
  double launches = 0;
  for (const double run : json.at("kernel_runs")) launches += run;
  CHECK(json.at("seconds").at("kernel").get<double>() == Approx(launches).epsilon(0.05).margin(0.01));
  CHECK(json.at("rays").at("camera") == 2 * 32 * 24);
  CHECK(json.at("rays").at("shadow").is_null());
  CHECK(json.at("rays").at("bounce").is_null());
  CHECK(json.at("bytes").at("device") > 0);
  CHECK(json.at("bytes").at("host") > 0);
  CHECK(json.at("precision") == "robust");
  CHECK(json.at("spp") == 2);
  CHECK(json.at("seed") == 5);
  CHECK_FALSE(json.at("device").get<std::string>().empty());
  const auto features = json.at("features").get<std::vector<std::string>>();
  CHECK(std::find(features.begin(), features.end(), "shapes/sphere") != features.end());
  CHECK_FALSE(json.contains("detail"));
}

TEST_CASE("the timed program is the one that explain names; detail comes from another") {
  const Folder folder;
  const Json json = stats(folder, {"--stats-detail", "--lanes", "8"});
  const Outcome explained = folder.run({"explain", "scene.xml", "--json", "--lanes", "8"});
  CHECK(json.at("program") == Json::parse(explained.out).at("program"));
  CHECK(json.at("detail").at("program") != json.at("program"));
  CHECK(json.at("rays").at("shadow") == 0);
  CHECK(json.at("rays").at("bounce") == 0);
}

TEST_CASE("detail counts what rays visit: all that is listed; of a tree less, and nodes") {
  const Folder folder;
  const Json list = stats(folder, {"--stats-detail", "--lanes", "8", "--accel", "list"});
  CHECK(list.at("visits").at("nodes") == 0);
  CHECK(list.at("visits").at("primitives") == list.at("rays").at("camera"));
  const Json tree = stats(folder, {"--stats-detail", "--lanes", "8", "--accel", "tree"});
  CHECK(tree.at("visits").at("primitives") <= tree.at("rays").at("camera"));
  CHECK(stats(folder, {}).at("visits").at("nodes").is_null());
  // As many samples as the run had.
  std::vector<std::string> of_part{"--stats-detail", "--lanes", "8", "--accel", "list", "--spp", "8"};
  of_part.insert(of_part.end(), {"--samples", "2:4", "--checkpoint", "part"});
  const Json shared = stats(folder, of_part);
  of_part.insert(of_part.end(), {"--disable", "SHARED_SAMPLES"});
  const Json part = stats(folder, of_part);
  CHECK(part.at("rays").at("camera") == 2 * 32 * 24);
  CHECK(part.at("visits").at("primitives") == part.at("rays").at("camera"));
  // Pixels at the border are made of samples beyond it.
  CHECK(shared.at("rays").at("camera") == 2 * 32 * 24);
  CHECK(shared.at("visits").at("primitives") > 2 * 32 * 24);
  // Also where the picture's rays go together.
  const Json together = stats(folder, {"--stats-detail", "--paths", "lanes", "--lanes", "8", "--accel", "list"});
  CHECK(together.at("path_lanes") == 8);
  CHECK(together.at("visits") == list.at("visits"));
}

TEST_CASE("- is standard output, with nothing else on it") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  const Outcome outcome = folder.run({"scene.xml", "--stats", "-"});
  REQUIRE(outcome.code == 0);
  CHECK(Json::parse(outcome.out).contains("seconds"));
}
