// SPDX-License-Identifier: MIT
// The benchmark's driver: it believes right answers only, and reports what it measured. 3 s.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "bench/primitives.h"
#include "bench/race.h"
#include "bench/report.h"
#include "support/devices.h"

using namespace strahl;
using namespace strahl::test;

namespace {

const std::vector<Precision> tiers{Precision::fast, Precision::robust};

}  // namespace

TEST_CASE("every workload hits and misses, and the tiers answer it right") {
  require_pocl();
  const Device device = Device::open("pocl");
  std::vector<bench::Timing> timings;
  for (const std::string& name : bench::primitive_names()) {
    INFO(name);
    const bench::Workload workload = bench::primitive_workload(name, 512);
    for (const bench::Timing& timing : bench::time_tiers(device, workload, tiers, 1)) {
      CHECK(timing.nanoseconds > 0);
      CHECK(timing.hits > 0.1);
      CHECK((timing.hits < 0.9 || name == "plane"));
      timings.push_back(timing);
    }
  }
  const bench::Run run{"a device", 512, 1};
  const auto json = nlohmann::json::parse(bench::json(run, timings));
  CHECK(json["timings"].size() == 2 * bench::primitive_names().size());
  CHECK(json["timings"][0]["ratio"] == 1.0);
  CHECK(json["timings"][1]["precision"] == "robust");
  CHECK(bench::markdown(run, timings).find("| 64 × sphere | ") != std::string::npos);
}

TEST_CASE("wrong hits have no time") {
  require_pocl();
  const Device device = Device::open("pocl");
  bench::Workload workload = bench::primitive_workload("sphere", 512);
  REQUIRE_NOTHROW(bench::time_tiers(device, workload, tiers, 1));
  workload.hits[7] = !workload.hits[7];
  CHECK_THROWS_WITH(bench::time_tiers(device, workload, tiers, 1), Catch::Contains("1 of 512 rays"));
}

TEST_CASE("an unknown primitive is named with those that there are") {
  CHECK_THROWS_WITH(bench::primitive_workload("teapot", 1), Catch::Contains("sphere, plane"));
}

TEST_CASE("the median is the middle") {
  CHECK(median({3, 1, 2}) == 2);
  CHECK(median({4, 1, 2, 3}) == 2.5);
}
