// SPDX-License-Identifier: MIT
// What telling the tier's rounding may cost: a twentieth of the run, or it is not begun.
#include <catch2/catch.hpp>

#include "render/rounding_pilot.h"

namespace strahl {
namespace {

/// 300 x 300 pixels, 16 samples of 2 us each.
RunStats run_of(double program_seconds, bool from_cache) {
  RunStats run;
  run.camera_rays = 300ULL * 300 * 16;
  run.seconds.kernel = 2e-6 * static_cast<double>(run.camera_rays);
  run.seconds.program = program_seconds;
  run.program_from_cache = from_cache;
  run.seconds.upload = 0.001;
  return run;
}

/// Of the least that can be told: two seeds of 4 samples, 15 samples of the run each.
double least_seconds(int side) { return side * side * 2 * 4 * 15 * 2e-6; }

TEST_CASE("a program that is yet to be built costs what the run's own did") {
  CHECK(rounding_pilot_side(run_of(3.0, false), false, 0.3) == 0);
  CHECK(rounding_pilot_side(run_of(3.0, false), false, 4.0) == 40);
}

TEST_CASE("where the run has built nothing, a build may take half a minute") {
  CHECK(rounding_pilot_side(run_of(0.1, true), false, 20.0) == 0);
  CHECK(rounding_pilot_side(run_of(0.1, true), false, 31.0) == 40);
}

TEST_CASE("a cached program leaves its time to the pictures, which are as large as fits") {
  const RunStats run = run_of(0.1, true);
  CHECK(rounding_pilot_side(run, true, 0.1) == 0);
  const int side = rounding_pilot_side(run, true, 0.3);
  CHECK(side > 12);
  CHECK(side < 40);
  CHECK(0.1 + 0.002 + least_seconds(side) <= 0.3);
  CHECK(rounding_pilot_side(run, true, 0.1 + 0.002 + 0.99 * least_seconds(12)) == 0);
}

TEST_CASE("who asks for it gets it whatever it takes; a picture without samples has none") {
  CHECK(rounding_pilot_side(run_of(100, true), false, std::nullopt) == 40);
  CHECK(rounding_pilot_side({}, true, 100.0) == 0);
}

TEST_CASE("the reference takes nothing over that was chosen for the tier's program") {
  RenderSettings settings;
  settings.precision = Precision::stable;
  settings.work_group = WorkGroup{32, 32};
  settings.lanes = 16;
  settings.bvh_width = 8;
  settings.generic = true;
  settings.disabled = {"EMISSION"};
  const RenderSettings exact = in_double_precision(settings);
  CHECK(exact.precision == Precision::fp64);
  CHECK_FALSE(exact.work_group);
  CHECK_FALSE(exact.lanes);
  CHECK_FALSE(exact.bvh_width);
  CHECK_FALSE(exact.generic);
  CHECK(exact.disabled == settings.disabled);
}

}  // namespace
}  // namespace strahl
