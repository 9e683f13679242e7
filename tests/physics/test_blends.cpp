// SPDX-License-Identifier: MIT
// Which row of the material table is drawn where materials blend others: in proportion to the weights, within blends,
// masks and sides, in every tier, and alike at every width.
#include <catch2/catch.hpp>
#include <map>

#include "physics/transport_scenes.h"

using namespace strahl;
using namespace strahl::test;

namespace {

constexpr Triad above{0, 0, 1}, below{0, 0, -1};

Reflectance share(double weight) { return {{weight, weight, weight}}; }

int add(Scene& scene, Blend blend) {
  Material material;
  material.bsdf = blend;
  scene.materials.push_back(material);
  return static_cast<int>(scene.materials.size()) - 1;
}

/// Materials 0, 1 and 2 are diffuse; the shape's is to be named.
Scene three_materials() {
  Scene scene = empty_scene();
  scene.materials.assign(3, {});
  scene.shapes.emplace_back().geometry = Sphere{};
  return scene;
}

std::vector<DrawnRow> rows(const TransportTier& tier, Scene scene, int material, const std::vector<SeenPlace>& places) {
  scene.shapes[0].material = material;
  return tier.rows(TierScene(scene, tier).buffers(), places);
}

std::vector<SeenPlace> numbers(const Triad& out, int count = 4096) {
  std::vector<SeenPlace> places;
  for (int i = 0; i < count; ++i) places.push_back({0.3, 0.3, (i + 0.5) / count, out});
  return places;
}

/// How often each row is drawn, of 1.
std::map<int, double> shares(const std::vector<DrawnRow>& drawn) {
  std::map<int, double> shares;
  for (const DrawnRow& row : drawn) shares[row.row] += 1.0 / static_cast<double>(drawn.size());
  return shares;
}

TEST_CASE("rows of blends are drawn in proportion to their weights, also within blends") {
  Scene scene = three_materials();
  const int inner = add(scene, {share(0.25), 0, 1}), outer = add(scene, {share(0.375), inner, 2});
  const int twice = add(scene, {share(0.5), outer, inner});
  for (const TransportTier& tier : transport_tiers()) {
    INFO(tier.name << ", " << tier.lanes << " lanes");
    std::map<int, double> found = shares(rows(tier, scene, outer, numbers(above)));
    CHECK(found.size() == 3);
    CHECK(found[0] == Approx(0.625 * 0.75).margin(1e-3));
    CHECK(found[1] == Approx(0.625 * 0.25).margin(1e-3));
    CHECK(found[2] == Approx(0.375).margin(1e-3));
    found = shares(rows(tier, scene, twice, numbers(above)));
    CHECK(found[0] == Approx(0.5 * 0.625 * 0.75 + 0.5 * 0.75).margin(1e-3));
    CHECK(found[2] == Approx(0.5 * 0.375).margin(1e-3));
  }
}

TEST_CASE("weights of 0 and 1 leave the other material out, whatever the number") {
  Scene scene = three_materials();
  const int first = add(scene, {share(0), 0, 1}), second = add(scene, {share(1), 0, 1});
  const int nested = add(scene, {share(0.3), first, second}), deep = add(scene, {share(0.9), second, nested});
  std::vector<SeenPlace> places;
  for (const double number : {0x1p-33, 1e-6, 0.3, 0.3 - 0x1p-26, 0.9, 0.9 - 0x1p-25, 1 - 0x1p-24})
    places.push_back({0, 0, number, above});
  for (const TransportTier& tier : transport_tiers()) {
    INFO(tier.name << ", " << tier.lanes << " lanes");
    for (const DrawnRow& row : rows(tier, scene, first, places)) CHECK(row.row == 0);
    for (const DrawnRow& row : rows(tier, scene, second, places)) CHECK(row.row == 1);
    for (const DrawnRow& row : rows(tier, scene, deep, places)) CHECK((row.row == 0 || row.row == 1));
  }
}

TEST_CASE("a texture may be the weight, of which the luminance counts") {
  Scene scene = three_materials();
  Checkerboard board;
  board.color0 = {0, 0, 1};
  board.color1 = {1, 1, 1};
  scene.textures.emplace_back().pattern = board;
  Blend blend{share(0.5), 1, 2};
  blend.weight.texture = 0;
  const int material = add(scene, blend);
  for (const TransportTier& tier : transport_tiers()) {
    INFO(tier.name << ", " << tier.lanes << " lanes");
    CHECK(shares(rows(tier, scene, material, numbers(above)))[2] == Approx(0.0722).margin(1e-3));
    for (const DrawnRow& row : rows(tier, scene, material, {{0.3, 0.7, 0.999, above}, {0.7, 0.3, 0.999, below}}))
      CHECK(row.row == 2);
  }
}

TEST_CASE("blends and sides: around, within, and as a back") {
  Scene scene = three_materials();
  scene.materials[1].twosided = true;
  const int within = add(scene, {share(0.5), 1, 2}), around = add(scene, {share(0.5), 0, 2});
  scene.materials.back().twosided = true;
  scene.materials.emplace_back().twosided = true;
  scene.materials.back().back = within;
  const int as_back = static_cast<int>(scene.materials.size()) - 1;
  const auto normals_of = [](const std::vector<DrawnRow>& drawn) {
    std::map<int, Triad> normals;
    for (const DrawnRow& row : drawn) normals[row.row] = row.normal;
    return normals;
  };
  using Normals = std::map<int, Triad>;
  for (const TransportTier& tier : transport_tiers()) {
    INFO(tier.name << ", " << tier.lanes << " lanes");
    const auto seen = [&](int material, const Triad& out) {
      return normals_of(rows(tier, scene, material, numbers(out, 64)));
    };
    CHECK(seen(within, above) == Normals{{1, above}, {2, above}});
    CHECK(seen(within, below) == Normals{{1, {-0.0, -0.0, -1}}, {2, above}});
    CHECK(seen(around, below) == Normals{{0, below}, {2, below}});
    CHECK(seen(as_back, above) == Normals{{as_back, above}});
    CHECK(seen(as_back, below) == Normals{{1, below}, {2, below}});
  }
}

TEST_CASE("masks around blends and within them let pass what both do") {
  Scene scene = three_materials();
  scene.materials[1].opacity = share(0.25);
  const int within = add(scene, {share(0.5), 0, 1});
  add(scene, {share(0.5), within, 2});
  scene.materials.back().opacity = share(0.5);
  const int around = static_cast<int>(scene.materials.size()) - 1;
  for (const TransportTier& tier : transport_tiers()) {
    INFO(tier.name << ", " << tier.lanes << " lanes");
    for (const DrawnRow& row : rows(tier, scene, within, numbers(above, 64)))
      CHECK(row.opacity == (row.row == 1 ? 0.25 : 1));
    for (const DrawnRow& row : rows(tier, scene, around, numbers(above, 64)))
      CHECK(row.opacity == (row.row == 1 ? 0.125 : 0.5));
  }
}

TEST_CASE("every width draws the rows of one lane") {
  Scene scene = three_materials();
  scene.materials[1].twosided = true;
  scene.textures.emplace_back().pattern = Checkerboard{};
  Blend textured{share(0.5), 0, 1};
  textured.weight.texture = 0;
  const int first = add(scene, textured), second = add(scene, {share(0.3), first, 2});
  std::vector<SeenPlace> places;
  std::mt19937_64 engine(5);
  for (int i = 0; i < 301; ++i)
    places.push_back({unit_number(engine), unit_number(engine), unit_number(engine), i % 3 == 0 ? below : above});
  std::map<std::string, std::vector<DrawnRow>> narrow;
  for (const TransportTier& tier : transport_tiers())
    if (tier.lanes == 1) narrow[tier.name] = rows(tier, scene, second, places);
  for (const TransportTier& tier : transport_tiers()) {
    const std::vector<DrawnRow> wide = rows(tier, scene, second, places);
    INFO(tier.name << ", " << tier.lanes << " lanes");
    for (std::size_t i = 0; i < wide.size(); ++i) {
      CHECK(wide[i].row == narrow[tier.name][i].row);
      CHECK(wide[i].normal == narrow[tier.name][i].normal);
    }
  }
}

}  // namespace
