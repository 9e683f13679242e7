// SPDX-License-Identifier: MIT
// The tables that choosers of lights read: by power whatever lights are drawn weigh one over the chance that they are
// drawn with, however unlike they are.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "packing/cl_layout.h"
#include "packing/pack.h"

using namespace strahl;

namespace {

struct Lamp {
  double brightness, weight;
};

/// Points, then lights from afar, around a ball.
Scene scene_of(const std::vector<Lamp>& near, const std::vector<Lamp>& far) {
  Scene scene;
  scene.integrator.name = "path";
  scene.shapes.emplace_back().geometry = Sphere{};
  const auto add = [&](auto emitter, double weight) {
    Light& light = scene.lights.emplace_back();
    light.emitter = emitter;
    light.sampling_weight = weight;
  };
  for (const Lamp& lamp : near)
    add(PointLight{{0, 2, 0}, {lamp.brightness, lamp.brightness, lamp.brightness}}, lamp.weight);
  for (const Lamp& lamp : far)
    add(DirectionalLight{{0, -1, 0}, {lamp.brightness, lamp.brightness, lamp.brightness}}, lamp.weight);
  return scene;
}

struct Chances {
  std::vector<double> told, drawn;  ///< One over the rarities; the shares of the numbers.
};

template <typename Real>
Chances chances_by_power(const Scene& scene) {
  RenderSettings settings;
  settings.light_choice = "power";
  const PackedScene<Real> packed = pack_scene<Real>(scene, features_of(scene, settings), PackOptions{1, {}});
  const auto index = [&](int at) { return packed.index.at(static_cast<std::size_t>(at)); };
  Chances chances;
  double begin = 0;
  for (int i = 0; i < static_cast<int>(scene.lights.size()); ++i) {
    const int last = index(index(layout::HEADER_CHOICES) + i * layout::CHOICE_INTS + layout::CHOICE_LAST);
    const double end = 1.0 + static_cast<std::uint32_t>(last);
    chances.drawn.push_back((end - begin) * 0x1p-32);
    begin = end;
    const int rarity_at = index(layout::HEADER_CHANCES) + i;
    chances.told.push_back(1 / static_cast<double>(packed.shading.at(static_cast<std::size_t>(rarity_at))));
  }
  return chances;
}

void hold_alike(const Chances& chances) {
  for (std::size_t i = 0; i < chances.told.size(); ++i) {
    INFO("light " << i);
    CHECK(chances.drawn[i] > 0);
    CHECK(chances.told[i] == Approx(chances.drawn[i]).epsilon(0x1p-22));
  }
}

}  // namespace

TEST_CASE("lights that are drawn seldom weigh one over the chance that they are drawn with") {
  for (const double weight : {1e-3, 1e-9, 1e-17, 1e-300}) {
    INFO(weight);
    for (const Scene& scene : {scene_of({{1, weight}, {1, 1}}, {}), scene_of({}, {{1, 1}, {1, weight}, {2, 1}}),
                               scene_of({{1, 1}, {1, weight}}, {{1, 1}, {1, weight}})}) {
      hold_alike(chances_by_power<float>(scene));
      hold_alike(chances_by_power<double>(scene));
    }
  }
}

TEST_CASE("lights from afar and near ones have an eighth, however unlike they are") {
  for (const double brightness : {1e-5, 1e-17, 1e-30, 1e-300})
    for (const bool is_far_dim : {false, true}) {
      INFO(brightness << ", " << is_far_dim);
      const Lamp dim{brightness, 1}, bright{1, 1};
      const Chances chances =
          chances_by_power<double>(is_far_dim ? scene_of({bright}, {dim}) : scene_of({dim}, {bright}));
      hold_alike(chances);
      CHECK(chances.told[is_far_dim ? 1 : 0] == Approx(0.125));
    }
}

TEST_CASE("a light is drawn where its weight times its power overflows") {
  const double largest = std::numeric_limits<double>::max();
  const Chances one = chances_by_power<double>(scene_of({{100, largest}, {100, 1}}, {}));
  hold_alike(one);
  CHECK(one.drawn[0] == Approx(1));
  const Chances two = chances_by_power<double>(scene_of({{1, largest}, {3, largest}}, {}));
  hold_alike(two);
  CHECK(two.drawn[0] == Approx(0.25));
}

TEST_CASE("n equal lights weigh exactly n") {
  for (const std::size_t n : {2, 3, 7, 100}) {
    const Scene scene = scene_of(std::vector<Lamp>(n, {0.3, 1}), {});
    for (const double told : chances_by_power<float>(scene).told) CHECK(told == 1.0 / static_cast<double>(n));
    for (const double told : chances_by_power<double>(scene).told)
      CHECK(told == Approx(1.0 / static_cast<double>(n)).epsilon(1e-14));
  }
}
