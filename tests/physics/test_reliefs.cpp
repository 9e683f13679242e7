// SPDX-License-Identifier: MIT
// Normals that textures bend: values of Mitsuba 3 (mitsuba_reliefs.txt, written by
// tests/acceptance/mitsuba_reliefs.py), draws against values, no light through the surface, the bits of every width;
// and the gradients of texture coordinates on every shape, against differences.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <regex>
#include <sstream>

#include "physics/transport_scenes.h"
#include "scene/scene_text.h"

using namespace strahl;
using namespace strahl::test;

namespace {

double dot(const Triad& a, const Triad& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// The material of a <bsdf> on the scene's only shape, which the tiers' places are of.
Scene scene_of(const std::string& bsdf) {
  const std::string body = std::regex_replace(bsdf, std::regex("ROOT"), STRAHL_SOURCE_DIR);
  Scene scene = empty_scene();
  const Scene read = load_body(body).scene;
  scene.materials = read.materials;
  scene.textures = read.textures;
  scene.shapes.emplace_back().geometry = Sphere{};
  scene.shapes[0].material = static_cast<int>(scene.materials.size()) - 1;
  return scene;
}

struct Value {
  SeenPlace place;
  Triad wi, wanted;
};

struct Case {
  std::string bsdf;
  std::vector<Value> values;
};

std::vector<Case> cases() {
  std::ifstream file(STRAHL_SOURCE_DIR "/tests/physics/mitsuba_reliefs.txt");
  REQUIRE(file);
  std::vector<Case> all;
  for (std::string line; std::getline(file, line);) {
    if (line[0] == '#') continue;
    if (line[0] == '<') {
      all.push_back({line, {}});
      continue;
    }
    std::istringstream numbers(line);
    Value value{};
    numbers >> value.place.u >> value.place.v;
    for (Triad* triad : {&value.place.out, &value.wi, &value.wanted})
      for (double& x : *triad) numbers >> x;
    REQUIRE(numbers);
    value.place.number = 0.5;
    all.back().values.push_back(value);
  }
  return all;
}

std::vector<Lit> lit(const TransportTier& tier, const TierScene& scene, const std::vector<Value>& values) {
  std::vector<SeenPlace> places;
  std::vector<Triad> wi, numbers;
  std::mt19937_64 engine(3);
  for (const Value& value : values) {
    places.push_back(value.place);
    wi.push_back(value.wi);
    numbers.push_back({unit_number(engine), unit_number(engine), unit_number(engine)});
  }
  return tier.lit(scene.buffers(), places, wi, numbers);
}

TEST_CASE("reliefs scatter what Mitsuba's do") {
  std::size_t count = 0;
  for (const Case& one : cases())
    for (const TransportTier& tier : transport_tiers()) {
      const TierScene scene(scene_of(one.bsdf), tier);
      const std::vector<Lit> found = lit(tier, scene, one.values);
      count += found.size();
      for (std::size_t i = 0; i < found.size(); ++i) {
        const Value& value = one.values[i];
        INFO(tier.name << ", " << tier.lanes << " lanes, " << one.bsdf << "\nwo "
                       << Catch::Detail::stringify(value.place.out) << ", wi " << Catch::Detail::stringify(value.wi));
        // Mitsuba's luminance of raw texels has other weights: 0.21267, 0.71516, 0.07217.
        for (std::size_t k = 0; k < 3; ++k)
          CHECK(found[i].value[k] == Approx(value.wanted[k]).epsilon(2e-4).margin(1e-5));
      }
    }
  CHECK(count > 2000);
}

TEST_CASE("heights times 0, and heights that a texture does not vary, leave the surface as smooth as it is") {
  const std::string metal = "<bsdf type=\"twosided\"><bsdf type=\"roughconductor\"/></bsdf>", end = "</bsdf>";
  const std::string letter =
      "<texture type=\"bitmap\"><string name=\"filename\" value=\"ROOT/scenes/textures/letter.png\"/></texture>";
  const std::vector<std::string> flat{
      "<bsdf type=\"bumpmap\"><float name=\"scale\" value=\"0\"/>" + letter + metal + end,
      "<bsdf type=\"bumpmap\"><texture type=\"scale\"><float name=\"scale\" value=\"0\"/>" + letter + "</texture>" +
          metal + end,
      "<bsdf type=\"bumpmap\"><texture type=\"wireframe\"/>" + metal + end};
  const std::vector<Value> values = cases().front().values;
  for (const TransportTier& tier : transport_tiers()) {
    const std::vector<Lit> wanted = lit(tier, TierScene(scene_of(metal), tier), values);
    for (const std::string& bsdf : flat) {
      const std::vector<Lit> found = lit(tier, TierScene(scene_of(bsdf), tier), values);
      REQUIRE(found.size() > 10);
      for (std::size_t i = 0; i < found.size(); ++i) {
        INFO(tier.name << ", " << tier.lanes << " lanes, " << bsdf);
        for (std::size_t k = 0; k < 3; ++k)
          CHECK(found[i].value[k] == Approx(wanted[i].value[k]).epsilon(1e-3).margin(1e-6));
      }
    }
  }
}

/// Also maps that Mitsuba leaks light with: normals below the surface, and two sides without turned normals.
std::vector<Case> hard_cases() {
  std::vector<Case> all = cases();
  const std::string metal = "<bsdf type=\"twosided\"><bsdf type=\"roughconductor\"/></bsdf>",
                    white = "<bsdf type=\"twosided\"><bsdf type=\"diffuse\"/></bsdf>",
                    as_it_is = "<boolean name=\"flip_invalid_normals\" value=\"false\"/>";
  for (const char* normal : {"0.95, 0.5, 0.45", "0.5, 0.5, 0", "0.5, 0.5, 0.5", "1, 0.5, 0.5"})
    for (const std::string& inside : {metal, white, metal + as_it_is, white + as_it_is}) {
      all.push_back(all.front());
      all.back().bsdf = std::string("<bsdf type=\"normalmap\"><rgb name=\"normalmap\" value=\"") + normal + "\"/>" +
                        inside + "</bsdf>";
    }
  return all;
}

/// Each place many times, seen from upright to grazing.
std::vector<Value> drawn_values(const Case& one) {
  std::vector<Value> values;
  std::mt19937_64 engine(8);
  for (const double cosine : {1.0, 0.7, 0.2, 0.01, 1e-7, -0.3, -1e-4})
    for (int i = 0; i < 48; ++i) {
      Value value = one.values[static_cast<std::size_t>(i) % one.values.size()];
      const double turn = 2 * std::numbers::pi * unit_number(engine), sine = std::sqrt(1 - cosine * cosine);
      value.place.out = {sine * std::cos(turn), sine * std::sin(turn), cosine};
      values.push_back(value);
    }
  return values;
}

TEST_CASE("draws at reliefs are finite, of the values told for them, and stay on their side of the surface") {
  int drawn = 0;
  for (const Case& one : hard_cases())
    for (const TransportTier& tier : transport_tiers()) {
      const TierScene scene(scene_of(one.bsdf), tier);
      const bool is_glass = one.bsdf.find("dielectric") != std::string::npos;
      std::vector<Value> values = drawn_values(one);
      const std::vector<Lit> ways = lit(tier, scene, values);
      std::vector<std::size_t> at;
      std::vector<Value> there;
      for (std::size_t i = 0; i < ways.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) CHECK(std::isfinite(ways[i].weight[k]));
        if (ways[i].weight[0] == 0) continue;
        INFO(tier.name << ", " << tier.lanes << " lanes, " << one.bsdf << ", wo "
                       << Catch::Detail::stringify(values[i].place.out) << ", wi "
                       << Catch::Detail::stringify(ways[i].drawn));
        const bool is_through = (ways[i].lobe & 2) != 0;
        CHECK((is_glass || !is_through));
        CHECK((values[i].place.out[2] * ways[i].drawn[2] > 0) == !is_through);
        at.push_back(i);
        there.push_back(values[i]);
        there.back().wi = ways[i].drawn;
      }
      const std::vector<Lit> told = lit(tier, scene, there);
      const double bound = roundoff(tier) * 2e4;
      for (std::size_t k = 0; k < told.size(); ++k) {
        const Lit& way = ways[at[k]];
        if (std::fabs(way.drawn[2]) < 0.02 || std::fabs(values[at[k]].place.out[2]) < 0.02) continue;
        INFO(tier.name << ", " << tier.lanes << " lanes, " << one.bsdf << ", wo "
                       << Catch::Detail::stringify(values[at[k]].place.out) << ", wi "
                       << Catch::Detail::stringify(way.drawn));
        ++drawn;
        CHECK(told[k].density == Approx(way.drawn_density).epsilon(bound));
        CHECK(told[k].value[0] == Approx(way.weight[0] * way.drawn_density).epsilon(bound));
      }
    }
  CHECK(drawn > 5000);
}

TEST_CASE("every width bends normals as one lane does, to the bit") {
  for (const Case& one : hard_cases()) {
    std::map<std::string, std::vector<Lit>> narrow;
    for (const TransportTier& tier : transport_tiers()) {
      const std::vector<Lit> found = lit(tier, TierScene(scene_of(one.bsdf), tier), drawn_values(one));
      if (tier.lanes == 1) narrow[tier.name] = found;
    }
    for (const TransportTier& tier : transport_tiers()) {
      if (tier.lanes == 1) continue;
      const std::vector<Lit> found = lit(tier, TierScene(scene_of(one.bsdf), tier), drawn_values(one));
      INFO(tier.name << ", " << one.bsdf);
      for (std::size_t i = 0; i < found.size(); ++i) {
        CHECK(found[i].value == narrow[tier.name][i].value);
        CHECK(found[i].weight == narrow[tier.name][i].weight);
        CHECK(found[i].drawn == narrow[tier.name][i].drawn);
      }
    }
  }
}

/// Of unit size, all hit from (3, 2, 4) around the origin.
std::vector<Geometry> shapes() {
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0.5}, {0, 1.5, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.uvs = {{0.1, 0.2}, {2, 0.3}, {-0.4, 1.7}};
  return {Sphere{{0, 0, 0}, 1.25, {{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}}},
          Plane{{0, 0, 0}, {0.2, 0.1, 1}, {1, 0.5, -0.25}, {-0.5, 2, -0.1}},
          Triangle{{-1, -1, 0}, {1, -1, 0.5}, {0, 1.5, 0}},
          Rectangle{{-1, -0.75, 0}, {2, 0.5, 0.25}, {0.5, 1.5, 0}},
          Disk{{0, 0, 0}, {1.2, 0, 0}, {0, 1.2, 0}},
          Cylinder{{-2, 0.1, 0}, {2, -0.1, 0.3}, 0.75},
          mesh};
}

TEST_CASE("gradients of texture coordinates are what the coordinates do, on every shape, placed or not") {
  TransportTier tier = transport_double().front();
  std::mt19937_64 engine(2);
  for (const bool is_placed : {false, true})
    for (const Geometry& geometry : shapes()) {
      // A group holds nothing infinite.
      if (is_placed && std::holds_alternative<Plane>(geometry)) continue;
      Scene scene = empty_scene();
      Shape shape;
      shape.geometry = geometry;
      // Whatever reads texture coordinates.
      scene.textures.emplace_back().pattern = Checkerboard{};
      scene.materials = {Material{}};
      scene.materials[0].bsdf = Diffuse{{{0.5, 0.5, 0.5}, 0}};
      if (is_placed) {
        scene.groups.emplace_back().shapes = {shape};
        Instance instance;
        instance.group = 0;
        instance.world_from_group.m = {{{1.5, 0.2, 0, 0.1}, {-0.1, 0.8, 0.1, 0}, {0, 0.3, 1.2, -0.2}}};
        scene.instances = {instance};
      } else {
        scene.shapes = {shape};
      }
      const TierScene packed(scene, tier);
      std::vector<GivenRay> rays;
      for (int i = 0; i < 40; ++i) {
        const Triad o{3, 2, 4}, aim{0.2 * unit_number(engine) - 0.1, 0.2 * unit_number(engine) - 0.1, 0.1};
        for (const double step : {0.0, 1e-5})
          for (const double turn : {0.0, 1.0})
            rays.push_back({o, {aim[0] + step * turn - o[0], aim[1] + step - o[1], aim[2] - o[2]}, 0, 1e6});
      }
      const std::vector<Mapped> found = tier.mapped(packed.buffers(), rays);
      INFO("alternative " << geometry.index() << (is_placed ? ", placed" : ""));
      for (std::size_t i = 0; i < found.size(); i += 4)
        for (const std::size_t other : {i + 2, i + 3}) {
          const Mapped &a = found[i], &b = found[other];
          Triad step{};
          for (std::size_t k = 0; k < 3; ++k) step[k] = b.position[k] - a.position[k];
          const double size = std::sqrt(dot(step, step));
          REQUIRE(size > 0);
          CHECK(b.u - a.u == Approx(dot(a.grad_u, step)).epsilon(1e-3).margin(1e-3 * size));
          CHECK(b.v - a.v == Approx(dot(a.grad_v, step)).epsilon(1e-3).margin(1e-3 * size));
        }
    }
}

}  // namespace
