// SPDX-License-Identifier: MIT
// What bench/run effects measures of scenes whose samples it may and may not compare, a small one of each sampler.
#include <catch2/catch.hpp>
#include <map>

#include "bench/effect_rows.h"
#include "bench/effects.h"
#include "support/devices.h"

using namespace strahl;

TEST_CASE("effects of a scene with each sampler") {
  test::require_pocl();
  bench::EffectsOptions options;
  options.folder = STRAHL_SOURCE_DIR "/scenes/";
  for (const char* name : {"cornell/cornell-box.xml", "accuracy/far-pebble.xml", "lecture/first-light.xml"})
    options.scenes.push_back(options.folder + name);
  options.rounds = 1;
  options.frame_seconds = 0.01;
  const bench::Effects effects =
      bench::measure_effects(Device::open("pocl"), options, [](const std::string& line) { UNSCOPED_INFO(line); });
  REQUIRE(effects.scenes.size() == 3);
  CHECK(effects.scenes[0].scene == "cornell/cornell-box.xml");
  for (const bench::SceneEffects& scene : effects.scenes) {
    INFO(scene.scene);
    CHECK(scene.study.variants.size() == (scene.of_16 ? 2 : 3));
    CHECK(scene.without_sums().ratio() > 0);
    CHECK(scene.whole(scene.study.variants[0]) > 0);
  }
  CHECK(effects.scenes[2].of_16.has_value());
  CHECK(effects.generic.bytes > effects.scenes[0].study.variants[0].bytes);
}

TEST_CASE("a row for each effect: from the scene of its name, else from the first that has it") {
  test::require_pocl();
  bench::EffectsOptions options;
  options.folder = STRAHL_SOURCE_DIR "/scenes/";
  for (const char* name : {"shapes/disk.xml", "shapes/plane.xml"}) options.scenes.push_back(options.folder + name);
  options.rounds = 1;
  options.frame_seconds = 0.001;
  const std::vector<bench::EffectRow> rows =
      bench::measure_effect_rows(Device::open("pocl"), options, [](const std::string& line) { UNSCOPED_INFO(line); });
  std::map<std::string, const bench::EffectRow*> of;
  for (const bench::EffectRow& row : rows) CHECK(of.emplace(row.effect, &row).second);
  REQUIRE(of.contains("shapes/plane"));
  CHECK(of["shapes/plane"]->scene == "shapes/plane.xml");
  CHECK(of["shapes/disk"]->cost.program_bytes > 0);
  CHECK(of["lights/point"]->scene == "shapes/disk.xml");
  CHECK_FALSE(of.contains("integrators/direct"));
}
