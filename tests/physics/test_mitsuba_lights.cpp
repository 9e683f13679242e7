// SPDX-License-Identifier: MIT
// Lights with textures shine as Mitsuba 3 has told (tests/acceptance/mitsuba_lights.py --write), from the scene file to
// the kernels: spots and projectors at points, shapes along rays.
#include <map>

#include "physics/mitsuba_table.h"
#include "physics/transport_scenes.h"
#include "scene/loader.h"

using namespace strahl;
using namespace strahl::test;

namespace {

struct Told {
  std::string scene, what;
  Triad at, colour;
};

std::vector<Told> all_told() { return told_by_mitsuba<Told>("mitsuba_lights.csv", {&Told::scene, &Told::what}); }

const Scene& scene_named(const std::string& name) {
  static std::map<std::string, Scene> scenes;
  const auto [found, is_new] = scenes.try_emplace(name);
  if (is_new) {
    found->second = load_scene(STRAHL_SOURCE_DIR "/tests/acceptance/scenes/" + name + ".xml").scene;
    found->second.integrator.name = "path";
  }
  return found->second;
}

TEST_CASE("lights with textures shine as Mitsuba's") {
  const std::vector<Told> all = all_told();
  REQUIRE(all.size() == 172);
  for (const TransportTier& tier : transport_tiers())
    for (const Told& told : all) {
      INFO(tier.name << ", " << tier.lanes << " lanes, " << told.scene << " at " << told.at[0] << " " << told.at[1]
                     << " " << told.at[2]);
      const TierScene scene(scene_named(told.scene), tier);
      const Triad found = told.what == "lamp"
                              ? tier.draw(scene.buffers(), {0}, told.at, place_numbers(1)).front().radiance
                              : tier.look(scene.buffers(), {0, 0, 0}, {told.at}).front().radiance;
      for (std::size_t k = 0; k < 3; ++k) CHECK(found[k] == Approx(told.colour[k]).epsilon(3e-4).margin(3e-5));
    }
}

struct LitPlaces {
  std::vector<Triad> directions, colours;
};

/// Seen from the origin.
LitPlaces lit_places(const TransportTier& tier, const TierScene& scene, int light,
                     const std::vector<PlaceNumbers>& numbers) {
  LitPlaces places;
  for (const LightDraw& drawn : tier.draw(scene.buffers(), {light}, {0, 0, 0}, numbers)) {
    if (drawn.radiance[0] <= 0) continue;
    places.directions.push_back(triad(normalized(vec(drawn.towards))));
    places.colours.push_back(drawn.radiance);
  }
  return places;
}

/// Places of a mesh know their attributes, as hits do.
TEST_CASE("places that are drawn on a mesh have its attributes") {
  const std::vector<PlaceNumbers> numbers = place_numbers(64);
  for (const TransportTier& tier : transport_tiers())
    for (const char* name : {"glowing-vertex_color", "glowing-vertex_heat", "glowing-face_color"}) {
      const TierScene packed(scene_named(name), tier);
      const auto [directions, colours] = lit_places(tier, packed, 0, numbers);
      REQUIRE(directions.size() > 32);
      const std::vector<Sight> seen = tier.look(packed.buffers(), {0, 0, 0}, directions);
      for (std::size_t i = 0; i < seen.size(); ++i) {
        INFO(tier.name << ", " << tier.lanes << " lanes, " << name << ", place " << i);
        for (std::size_t k = 0; k < 3; ++k) CHECK(seen[i].radiance[k] == Approx(colours[i][k]).epsilon(1e-3));
      }
    }
}

/// A place drawn on a shape shows what a ray to it sees; bilinear texels of 1/16 tell places to 1e-5 in u and v.
TEST_CASE("places that are drawn on glowing shapes are as bright as rays see them") {
  const Scene& scene = scene_named("glowing-shapes");
  const std::vector<PlaceNumbers> numbers = place_numbers(200);
  for (const TransportTier& tier : transport_tiers()) {
    const TierScene packed(scene, tier);
    for (int light = 0; light < 5; ++light) {
      INFO(tier.name << ", " << tier.lanes << " lanes, light " << light);
      const auto [directions, colours] = lit_places(tier, packed, light, numbers);
      REQUIRE(directions.size() > 50);
      const std::vector<Sight> seen = tier.look(packed.buffers(), {0, 0, 0}, directions);
      std::size_t missed = 0;
      for (std::size_t i = 0; i < seen.size(); ++i) {
        // Rounding moves a place past an edge, or over the seam where u is 0 and 1.
        const double off = std::fabs(seen[i].radiance[0] - colours[i][0]);
        if (seen[i].light != light || off > 1e-3) ++missed;
      }
      CHECK(missed <= seen.size() / 50);
    }
  }
}

}  // namespace
