// SPDX-License-Identifier: MIT
// `strahl explain --cost`: every effect that is on has its bill, or the reason why there is none. About 6 s.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/program.h"

using namespace strahl_test;
using Json = nlohmann::json;

namespace {

/// Programs that PoCL keeps for the next run.
auto kept_programs(const std::string& cache) {
  const std::filesystem::recursive_directory_iterator files(cache);
  return std::count_if(begin(files), end(files), [](const auto& file) { return file.path().extension() == ".so"; });
}

}  // namespace

TEST_CASE("what an effect adds to the program and to a frame") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  const std::string cache = folder.path("cache");
  std::filesystem::create_directory(cache);
  const Outcome outcome = folder.run({"explain", "scene.xml", "--cost", "effects", "--rounds", "1", "--json", "-d",
                                      "pocl", "--precision", "stable", "--aov", "depth"},
                                     {{"POCL_CACHE_DIR", cache}});
  INFO(outcome.err);
  REQUIRE(outcome.code == 0);
  const Json report = Json::parse(outcome.out);
  const Json& all = report.at("cost");
  const double bytes = all.at("program_bytes");
  CHECK(bytes > 1000);
  CHECK(kept_programs(cache) == 0);
  CHECK(all.at("build_seconds") > 0);
  CHECK(all.at("kernel_seconds") > 0);
  CHECK(all.at("width") == 32);
  CHECK(all.at("spp") == 1);
  CHECK(all.at("builds") == 1);
  CHECK(all.at("frames") == 3);
  int needed = 0, black = 0, timed = 0;
  for (const Json& feature : report.at("features")) {
    INFO(feature.dump());
    const Json& cost = feature.at("cost");
    REQUIRE(cost.is_null() != feature.at("on").get<bool>());
    if (cost.is_null()) continue;
    if (!cost.at("needed").is_null()) {
      ++needed;
      continue;
    }
    CHECK(cost.at("program_bytes") < bytes);
    CHECK(cost.at("build_seconds").is_number());
    if (feature.at("name") == "ERROR_SUMS") {
      CHECK(contains(cost.at("frame_needed"), "fewer than 4 samples"));
      CHECK(cost.at("kernel_seconds").is_null());
    } else if (cost.at("frame_needed").is_null()) {
      ++timed;
      CHECK(cost.at("kernel_seconds").is_number());
    } else {
      ++black;
      CHECK(cost.at("kernel_seconds").is_null());
    }
    if (feature.at("name") == "EMISSION") CHECK(cost.at("frame_needed") == "the picture would be black");
    if (feature.at("name") == "AOV") CHECK(cost.at("program_bytes") > 0);
  }
  CHECK(needed == 3);  // The integrator, the sampler, the only shape.
  CHECK(black == 1);
  CHECK(timed == 3);  // PIXEL_FILTER, SHARED_SAMPLES, AOV.
}

TEST_CASE("without --cost nothing is measured") {
  const Folder folder;
  folder.file("scene.xml", glowing_sphere);
  const Outcome outcome = folder.run({"explain", "scene.xml", "--json", "--lanes", "8"});
  REQUIRE(outcome.code == 0);
  CHECK_FALSE(Json::parse(outcome.out).contains("cost"));
  CHECK(folder.run({"explain", "scene.xml", "--rounds", "2"}).code == 2);
}
