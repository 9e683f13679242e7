// SPDX-License-Identifier: MIT
// The kernel that strahl's programs are held against renders strahl's picture, bit for bit, in every precision (it
// would throw), and all four programs are timed. In robust; STRAHL_ALL_TIERS=1: in every precision, half a minute.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <vector>

#include "bench/ten_spheres.h"
#include "support/devices.h"

using namespace strahl;

TEST_CASE("ten spheres by a kernel of their own") {
  test::require_pocl();
  const Device device = Device::open("pocl", {true});
  std::vector<Precision> precisions{Precision::robust};
  if (std::getenv("STRAHL_ALL_TIERS") != nullptr)
    precisions = {Precision::fast, Precision::stable, Precision::robust, Precision::fp64};
  for (const Precision precision : precisions) {
    const bench::TenSpheres times = bench::time_ten_spheres(device, precision, 64, 3);
    INFO(precision_name(precision));
    CHECK(times.pixels == 64 * 64);
    for (const auto* seconds : {&times.strahl, &times.generic, &times.minimal_lanes, &times.minimal_scalar}) {
      REQUIRE(seconds->size() == 3);
      for (const double one : *seconds) CHECK(one > 0);
    }
  }
}
