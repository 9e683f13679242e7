// SPDX-License-Identifier: MIT
// Checks every entry of cl/choosers/choosers.def in every tier and width: the probabilities sum to 1 over the lights
// that are drawn, the frequencies of lights match them (chi^2), and the probability of a drawn light equals the stated
// one. A new entry needs one row in `chooser_rows`.
#include <functional>

#include "physics/rows.h"
#include "physics/transport_scenes.h"

using namespace strahl;
using namespace strahl::test;

namespace {

struct ChooserRow {
  std::string entry;  ///< Of choosers.def.
  /// Changes a scene with this number of lights so that it uses the entry.
  std::function<void(Scene&)> call_for;
};

std::vector<ChooserRow> chooser_rows() {
  return {{"uniform", [](Scene&) {}}};
}

const std::vector<std::string> chooser_entries = {
#define CHOOSER(name) #name,
#include "../../cl/choosers/choosers.def"
#undef CHOOSER
};

/// Lamps, and spheres that a chooser may distinguish: near and far, bright and dark.
Scene scene_of_lights(int lamps, int spheres) {
  Scene scene = empty_scene();
  for (int i = 0; i < lamps; ++i) scene.lights.emplace_back().emitter = PointLight{{1.0 * i, 2, 0}, {1.0 + i, 1, 1}};
  for (int i = 0; i < spheres; ++i) {
    Shape& shape = scene.shapes.emplace_back();
    shape.geometry = Sphere{{0, 3.0 * i, 5}, 0.25 + 0.01 * i};
    shape.radiance = Rgb{1, 1.0 + i, 0.5};
  }
  return scene;
}

struct Count {
  int lamps, spheres;
  const char* integrator;  ///< direct takes the lamps, path draws them.
};

/// visit(tier, scene, first of those that are drawn, one past the last)
template <class Visit>
void for_each_chooser(Visit visit) {
  for (const ChooserRow& row : chooser_rows())
    for (const Count& count : {Count{0, 1, "path"}, Count{3, 4, "path"}, Count{3, 4, "direct"}, Count{0, 100, "path"}})
      for (const TransportTier& tier : transport_tiers()) {
        Scene scene = scene_of_lights(count.lamps, count.spheres);
        scene.integrator.name = count.integrator;
        row.call_for(scene);
        INFO(tier.name << ", " << tier.lanes << " lanes, " << row.entry << ", " << count.lamps << " lamps, "
                       << count.spheres << " spheres, " << count.integrator);
        const TierScene packed(scene, tier);
        visit(tier, packed, packed.index(layout::HEADER_LIGHTS_TAKEN), packed.index(layout::HEADER_LIGHT_COUNT));
      }
}

const Triad at{0.5, 1, 0.25};

TEST_CASE("every chooser has a row") {
  hold_rows("choosers.def", chooser_entries, chooser_rows(), [](const ChooserRow& row) {
    Scene scene = scene_of_lights(1, 2);
    row.call_for(scene);
    return TierScene(scene, true, 1).index(layout::HEADER_CHOOSER);
  });
}

TEST_CASE("chances sum to 1, and lights are drawn as often as that") {
  constexpr std::uint32_t samples = 8192;
  for_each_chooser([&](const TransportTier& tier, const TierScene& scene, int first, int end) {
    std::vector<double> counts(static_cast<std::size_t>(end), 0), expected = counts;
    double whole = 0;
    for (int light = first; light < end; ++light) {
      const double chance = 1 / tier.rarity(scene.buffers(), light, at);
      CHECK(chance > 0);
      expected[static_cast<std::size_t>(light)] = chance * samples;
      whole += chance;
    }
    CHECK(whole == Approx(1).epsilon(4 * roundoff(tier) * (end - first)));
    for (const LightPick& pick : tier.pick(scene.buffers(), at, samples)) {
      REQUIRE(pick.light >= first);
      REQUIRE(pick.light < end);
      CHECK(pick.rarity == pick.told);
      counts[static_cast<std::size_t>(pick.light)] += 1;
    }
    hold_counts(counts, expected);
  });
}

}  // namespace
