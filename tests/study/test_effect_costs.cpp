// SPDX-License-Identifier: MIT
// What an effect costs is told of frames that have it.
#include <catch2/catch.hpp>

#include "render/pictures.h"
#include "study/effect_costs.h"

namespace strahl::test {
namespace {

EffectCosts cost_of_sums(int spp) {
  VariantRounds rounds;
  rounds.builds = rounds.frames = 1;
  rounds.frame_seconds = 1e-9;  // No sample is so quick.
  const Scene scene = small_scene(scene_folder / "cornell/cornell-box.xml", 16, 16, spp);
  return measure_effects(Device::open("pocl"), scene, {}, rounds, {}, {"ERROR_SUMS"});
}

TEST_CASE("sub-sums are timed with as many samples as have them") {
  require_pocl();
  const EffectCosts costs = cost_of_sums(64);
  CHECK(costs.study.spp == 4);
  CHECK(costs.effects.at("ERROR_SUMS").frame_needed.empty());
  const EffectCosts few = cost_of_sums(3);
  CHECK(few.study.spp == 3);
  CHECK(few.effects.at("ERROR_SUMS").frame_needed == "fewer than 4 samples a pixel: no sub-sums");
}

}  // namespace
}  // namespace strahl::test
