// SPDX-License-Identifier: MIT
// The statistics' JSON: keys, nulls, numbers that cannot be written.
#include <catch2/catch.hpp>
#include <limits>
#include <nlohmann/json.hpp>

#include "errors.h"
#include "render/stats.h"
#include "settings/settings.h"

using Json = nlohmann::json;

TEST_CASE("other is what no phase accounts for, and never negative") {
  strahl::RunStats stats;
  stats.seconds = {
      .load = 1, .bvh = 2, .program = 3, .upload = 4, .kernel = 5, .readback = 6, .encode = 7, .total = 30};
  const Json seconds = Json::parse(stats.json()).at("seconds");
  CHECK(seconds.at("other") == 2.0);
  CHECK(seconds.at("total") == 30.0);
  CHECK(seconds.at("encode") == 7.0);
  CHECK(seconds.size() == 14);
  stats.seconds.total = 27.9;
  CHECK(Json::parse(stats.json()).at("seconds").at("other") == 0.0);
}

TEST_CASE("what was not counted is null") {
  strahl::RunStats stats;
  stats.camera_rays = 12;
  stats.shadow_rays = 5;
  const Json rays = Json::parse(stats.json()).at("rays");
  CHECK(rays.at("camera") == 12);
  CHECK(rays.at("shadow") == 5);
  CHECK(rays.at("bounce").is_null());
}

TEST_CASE("the longest launch is that of the list") {
  strahl::RunStats stats;
  CHECK(Json::parse(stats.json()).at("longest_launch") == 0.0);
  stats.kernel_runs = {0.1, 0.3, 0.2};
  CHECK(Json::parse(stats.json()).at("longest_launch") == 0.3);
  CHECK(Json::parse(stats.json()).at("launches") == 3);
}

TEST_CASE("a long render keeps no more and more launches") {
  strahl::RunStats stats, all;
  for (int i = 0; i < 5000; ++i) stats.add_launch(i == 4000 ? 2.0 : 0.5);
  for (int i = 0; i < 2; ++i) all.add_launches(stats);
  for (const strahl::RunStats* of : {&stats, &all}) {
    const Json json = Json::parse(of->json());
    CHECK(json.at("kernel_runs").size() == strahl::RunStats::most_kept_runs);
    CHECK(json.at("launches") == (of == &all ? 10000 : 5000));
    CHECK(json.at("longest_launch") == 2.0);
  }
}

TEST_CASE("no number and no name makes the text unreadable") {
  strahl::RunStats stats;
  stats.seconds.kernel = std::numeric_limits<double>::infinity();
  stats.kernel_runs = {std::numeric_limits<double>::quiet_NaN()};
  stats.device = "caf\xe9 GPU";  // Latin-1
  const Json json = Json::parse(stats.json());
  CHECK(json.at("seconds").at("kernel").is_null());
  CHECK(json.at("kernel_runs").at(0).is_null());
  CHECK(json.at("device").get<std::string>().find("GPU") != std::string::npos);
}

TEST_CASE("names of precisions and AOVs") {
  CHECK(strahl::precision_from_name("double") == strahl::Precision::fp64);
  CHECK(strahl::precision_from_name("robust") == strahl::Precision::robust);
  CHECK(std::string(strahl::precision_name(strahl::Precision::stable)) == "stable");
  CHECK(std::string(strahl::precision_name(strahl::Precision::robust)) == "robust");
  CHECK(std::string(strahl::precision_name(strahl::Precision::fp64)) == "double");
  CHECK(strahl::aov_from_name("primitive_id") == strahl::Aov::primitive_id);
  CHECK_THROWS_AS(strahl::precision_from_name("fp64"), strahl::UsageError);
  CHECK_THROWS_WITH(strahl::aov_from_name("Depth"), Catch::Contains("depth, normal, position"));
}
