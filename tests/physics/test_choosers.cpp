// SPDX-License-Identifier: MIT
// Checks every entry of cl/choosers/choosers.def in every tier and width: the probabilities sum to 1 over the lights
// that are drawn, the frequencies of lights match them (chi^2), and the probability of a drawn light equals the stated
// one.
#include "physics/rows.h"
#include "physics/transport_scenes.h"

using namespace strahl;
using namespace strahl::test;

namespace {

const std::vector<std::string> chooser_entries = {
#define CHOOSER(name) #name,
#include "../../cl/choosers/choosers.def"
#undef CHOOSER
};

/// Lamps, and spheres that a chooser may distinguish: near and far, bright and dark; every second lamp is a spot. Where
/// there are lamps, some of the light comes from afar.
Scene scene_of_lights(int lamps, int spheres) {
  Scene scene = empty_scene();
  for (int i = 0; i < lamps; ++i) {
    Light& light = scene.lights.emplace_back();
    if (i % 2 == 0)
      light.emitter = PointLight{{1.0 * i, 2, 0}, {1.0 + i, 1, 1}};
    else
      light.emitter = SpotLight{{1.0 * i, 2, 0}, {0.1 * i, -1, 0}, {5, 5, 5}, 70, 20};
  }
  if (lamps > 0) scene.lights.emplace_back().emitter = DirectionalLight{{1, -1, 0}, {0.5, 0.5, 0.5}};
  if (lamps > 0) scene.lights.emplace_back().emitter = ConstantLight{{0.1, 0.2, 0.3}};
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
  for (const std::string& entry : chooser_entries)
    for (const Count& count : {Count{0, 1, "path"}, Count{3, 4, "path"}, Count{3, 4, "direct"}, Count{0, 100, "path"}})
      for (const TransportTier& tier : transport_tiers()) {
        Scene scene = scene_of_lights(count.lamps, count.spheres);
        scene.integrator.name = count.integrator;
        INFO(tier.name << ", " << tier.lanes << " lanes, " << entry << ", " << count.lamps << " lamps, "
                       << count.spheres << " spheres, " << count.integrator);
        RenderSettings settings;
        settings.light_choice = entry;
        const TierScene packed(scene, tier, settings);
        const auto place = std::find(chooser_entries.begin(), chooser_entries.end(), entry) - chooser_entries.begin();
        if (count.lamps + count.spheres > 1) REQUIRE(packed.index(layout::HEADER_CHOOSER) == place);
        visit(tier, packed, packed.index(layout::HEADER_LIGHTS_TAKEN), packed.index(layout::HEADER_LIGHT_COUNT));
      }
}

const Triad at{0.5, 1, 0.25};

/// Of the lights from `first` on at a point: they sum to 1, and lights are drawn as often as that. Returns them.
std::vector<double> held_chances(const TransportTier& tier, const TierScene& scene, int first, int end,
                                 const Triad& from) {
  constexpr std::uint32_t samples = 8192;
  std::vector<double> counts(static_cast<std::size_t>(end), 0), expected = counts, chances;
  double whole = 0;
  for (int light = first; light < end; ++light) {
    const double chance = 1 / tier.rarity(scene.buffers(), light, from);
    CHECK(chance >= 0);
    expected[static_cast<std::size_t>(light)] = chance * samples;
    chances.push_back(chance);
    whole += chance;
  }
  CHECK(whole == Approx(1).epsilon(4 * roundoff(tier) * (end - first)));
  for (const LightPick& pick : tier.pick(scene.buffers(), from, samples)) {
    REQUIRE(pick.light >= first);
    REQUIRE(pick.light < end);
    CHECK(pick.rarity == pick.told);
    counts[static_cast<std::size_t>(pick.light)] += 1;
  }
  hold_counts(counts, expected);
  return chances;
}

TEST_CASE("chances sum to 1, and lights are drawn as often as that") {
  for_each_chooser([&](const TransportTier& tier, const TierScene& scene, int first, int end) {
    held_chances(tier, scene, first, end, at);
  });
}

/// A light from afar, then a ball and a lamp.
Scene scene_of_weights(double far, double near) {
  Scene scene = empty_scene();
  scene.lights.emplace_back().emitter = DirectionalLight{{1, -1, 0}, {1, 1, 1}};
  scene.lights.back().sampling_weight = far;
  scene.lights.emplace_back().emitter = PointLight{{1, 2, 0}, {1, 1, 1}};
  scene.lights.back().sampling_weight = near;
  Shape& ball = scene.shapes.emplace_back();
  ball.geometry = Sphere{{0, 3, 5}, 0.25};
  ball.radiance = Rgb{1, 1, 1};
  ball.sampling_weight = near;
  return scene;
}

TEST_CASE("lights of hardly any weight, or far out, take no chance from others") {
  struct Weights {
    double far, near;
    Triad from;
  };
  std::vector<Weights> cases;
  for (const double weight : {1.0, 1e-20, 1e-38, 1e-40, 1e-50, 1e-300}) {
    cases.push_back({weight, 1, at});
    cases.push_back({1, weight, at});
  }
  // From there what the lamps bring is too small for its reciprocal in single precision.
  const Triad beyond{8e18, 8e18, 8e18};
  for (const double weight : {1.0, 0.01, 0.001}) cases.push_back({1, weight, beyond});
  for (const std::string& entry : chooser_entries)
    for (const TransportTier& tier : transport_tiers())
      for (const auto& [far, near, from] : cases) {
        INFO(tier.name << ", " << tier.lanes << " lanes, " << entry << ", weights " << far << " and " << near << " at "
                       << from[0]);
        RenderSettings settings;
        settings.light_choice = entry;
        const TierScene scene(scene_of_weights(far, near), tier, settings);
        const std::vector<double> chances = held_chances(tier, scene, 0, 3, from);
        CHECK(chances[0] > 0.12);
        CHECK(chances[1] + chances[2] > 0.12);
      }
}

/// Lights of every kind that shine in all directions: points, narrow and wide cones, flat ones, balls, from afar.
Scene scene_of_many(std::mt19937_64& engine) {
  Scene scene = empty_scene();
  const auto within = [&](double least, double most) { return least + (most - least) * unit_number(engine); };
  const auto vector = [&] { return Vec3{within(-1, 1), within(-1, 1), within(-1, 1)}; };
  for (int i = 0; i < 12; ++i) {
    scene.lights.emplace_back().emitter = PointLight{4 * vector(), {within(0.1, 9), 1, 1}};
    const double cutoff = within(1, 120);
    scene.lights.emplace_back().emitter =
        SpotLight{4 * vector(), vector(), {within(0.1, 9), 1, 1}, cutoff, 0.5 * cutoff};
    Shape& flat = scene.shapes.emplace_back();
    flat.geometry = Rectangle{4 * vector(), vector(), vector()};
    flat.radiance = Rgb{within(0.1, 9), 1, 1};
    flat.sampling_weight = within(0.1, 3);
    Shape& ball = scene.shapes.emplace_back();
    ball.geometry = Sphere{4 * vector(), within(0.01, 1)};
    ball.radiance = Rgb{within(0.1, 9), 1, 1};
  }
  scene.lights.emplace_back().emitter = DirectionalLight{vector(), {1, 1, 1}};
  scene.lights.emplace_back().emitter = ConstantLight{};
  return scene;
}

TEST_CASE("whatever light reaches a point has a chance there") {
  std::mt19937_64 engine(19);
  const Scene scene = scene_of_many(engine);
  const std::vector<PlaceNumbers> numbers = place_numbers(16);
  for (const std::string& entry : chooser_entries)
    for (const TransportTier& tier : transport_tiers()) {
      RenderSettings settings;
      settings.light_choice = entry;
      const TierScene packed(scene, tier, settings);
      for (int i = 0; i < 40; ++i) {
        const double size = i % 4 == 0 ? 1e-3 : i % 4 == 1 ? 1e4 : 5;
        const Triad from{size * unit_number(engine), size * unit_number(engine), -size * unit_number(engine)};
        double whole = 0;
        for (int light = 0; light < packed.index(layout::HEADER_LIGHT_COUNT); ++light) {
          INFO(tier.name << ", " << tier.lanes << " lanes, " << entry << ", light " << light);
          const double chance = 1 / tier.rarity(packed.buffers(), light, from);
          whole += chance;
          for (const LightDraw& drawn : tier.draw(packed.buffers(), {light}, from, numbers))
            if (drawn.radiance[0] > 0) CHECK(chance > 0);
        }
        CHECK(whole == Approx(1).epsilon(1e-3));
      }
    }
}

}  // namespace
