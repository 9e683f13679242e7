// SPDX-License-Identifier: MIT
// Checks that lanes whose lights lie alike, which kernels ask together (cl/lights/light_rows_lanes.h), draw what each
// of them draws by itself, to the bit; and which lights the scene's table says lie alike.
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "image/texels.h"
#include "physics/area_rows.h"
#include "physics/transport_scenes.h"

using namespace strahl;
using namespace strahl::test;

namespace {

constexpr int copies = 3;

/// Of each kind several that differ in everything.
Scene scene_of_many_lights() {
  Scene scene = empty_scene();
  Bitmap ramp;
  ramp.texels = std::make_shared<const Texels>(texels_of_floats(2, 1, 1, {0.25F, 1}));
  scene.textures = {{"", ramp, {}, true}};
  for (int i = 0; i < copies; ++i) {
    const double x = 1.0 + i;
    scene.lights.emplace_back().emitter = PointLight{{x, 2, -x}, {x, 1, 0.5 * x}};
    scene.lights.emplace_back().emitter = SpotLight{{x, 3, 0}, {0.2 * x, -1, 0.1}, {5, x, 5}, 60.0 + 5 * i, 20.0 + i};
    scene.lights.emplace_back().emitter = DirectionalLight{{x, -1, 0}, {0.5, 0.5, x}};
  }
  for (const AreaRow& row : area_rows())
    for (int i = 0; i <= copies; ++i) {
      Shape shape = emitting_shape(row);
      shape.radiance = Rgb{1.0 + i, 2, 0.25 * i};
      if (i == copies) shape.radiance_texture = 0;
      scene.shapes.push_back(shape);
    }
  // Six items each.
  for (int i = 0; i < 2; ++i) {
    Shape& cube = scene.shapes.emplace_back();
    cube.geometry = Cube{{-4.0 - 3 * i, 1, 1}, {Vec3{1.0 + i, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 0.5}}};
    cube.radiance = Rgb{2, 1.0 + i, 3};
  }
  return scene;
}

TEST_CASE("lights that lie alike are drawn together as each is by itself, to the bit") {
  const std::vector<Vec3> froms = {{0.5, -1, 5}, {2, 0.5, 3}, {-40, 30, 100}};
  for (const TransportTier& tier : transport_tiers()) {
    const TierScene scene(scene_of_many_lights(), tier);
    const int count = scene.index(layout::HEADER_LIGHT_COUNT);
    const std::vector<PlaceNumbers> numbers = place_numbers(static_cast<std::size_t>(12 * count));
    // Neighbours differ, and each light meets many others: 11 and the count have no divisor in common.
    std::vector<int> lights(numbers.size());
    REQUIRE(count % 11 != 0);
    for (std::size_t i = 0; i < lights.size(); ++i) lights[i] = static_cast<int>(11 * i) % count;
    for (const Vec3& from : froms) {
      INFO(tier.name << ", " << tier.lanes << " lanes, from " << from.x);
      const std::vector<LightDraw> together = tier.draw(scene.buffers(), lights, triad(from), numbers);
      int lit = 0;
      for (int light = 0; light < count; ++light) {
        const std::vector<LightDraw> alone = tier.draw(scene.buffers(), {light}, triad(from), numbers);
        for (std::size_t i = 0; i < lights.size(); ++i) {
          if (lights[i] != light) continue;
          check_same(together[i], alone[i]);
          if (alone[i].radiance[1] > 0) ++lit;
        }
      }
      CHECK(lit > static_cast<int>(lights.size()) / 4);
    }
  }
}

TEST_CASE("lights of one item without a texture lie alike, kind by kind and area by area") {
  const TierScene scene(scene_of_many_lights(), false, 8);
  std::map<std::pair<int, int>, std::set<int>> of_kind;
  int alone = 0;
  for (int i = 0; i < scene.index(layout::HEADER_LIGHT_COUNT); ++i) {
    const int alike = scene.light(i, layout::LIGHT_ALIKE), kind = scene.light(i, layout::LIGHT_KIND);
    REQUIRE(alike <= i);
    CHECK(scene.light(alike, layout::LIGHT_KIND) == kind);
    CHECK(scene.light(alike, layout::LIGHT_AREA) == scene.light(i, layout::LIGHT_AREA));
    if (alike != i) {
      CHECK(scene.light(i, layout::LIGHT_TEXTURE) < 0);
      CHECK(scene.light(alike, layout::LIGHT_TEXTURE) < 0);
      of_kind[{kind, scene.light(i, layout::LIGHT_AREA)}].insert(alike);
    } else {
      ++alone;
    }
  }
  // Points, spots, and the five areas.
  CHECK(of_kind.size() == 2 + 5);
  for (const auto& [kind, firsts] : of_kind) CHECK(firsts.size() == 1);
  // The first of each, directional lights, those with a texture, and cubes.
  CHECK(alone == 7 + copies + 6 + 2);
}

}  // namespace
