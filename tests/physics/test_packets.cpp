// SPDX-License-Identifier: MIT
// Packets on the host: for every entry of cl/shapes/shapes.def the rays of a packet have the same hits as each ray
// alone, to the bit: in lists and in trees, nearest and any hit, also for rays that have left a primitive. With many
// more rays and on devices: tests/accel/test_packets.cpp.
#include <catch2/catch.hpp>

#include "cl/mixed_scenes.h"
#include "packing/cl_layout.h"
#include "packing/pack.h"
#include "physics/transport_tiers.h"

using namespace strahl;
using namespace strahl::test;

namespace {

/// Of an entry of shapes.def, a shape (cl/mixed_scenes.h) whose primitives are of that kind.
std::string shape_of(const std::string& entry) {
  if (entry == "triangle") return "mesh";
  if (entry == "parallelogram") return "rectangle";
  return entry;
}

const std::vector<std::string> shape_entries = {
#define SHAPE(name, planes) #name,
#include "../../cl/shapes/shapes.def"
#undef SHAPE
};

PackedScene<float> packed_for(Scene scene, int lanes, Acceleration acceleration) {
  scene.integrator.name = "emission";
  RenderSettings settings;
  settings.generic = true;
  return pack_scene<float>(scene, features_of(scene, settings), {lanes, UploadFrame{}, 0, acceleration});
}

TierBuffers buffers_of(const PackedScene<float>& packed) {
  return {packed.geometry.data(), packed.shading.data(), packed.index.data()};
}

GivenRay given(const Ray& ray) {
  return {{ray.origin.x, ray.origin.y, ray.origin.z},
          {ray.direction.x, ray.direction.y, ray.direction.z},
          ray.t_min,
          std::min(ray.t_max, static_cast<double>(std::numeric_limits<float>::max()))};
}

/// Sixteen rays around each ray of the maker, closer and closer together, some of them reversed.
std::vector<GivenRay> bundles(SceneMaker& maker, std::size_t count) {
  oracle::Random random(3);
  std::vector<GivenRay> rays;
  std::size_t number = 0;
  for (const Ray& leader : maker.rays(count / 16)) {
    const double width = std::pow(10.0, -1.0 - static_cast<double>(number++ % 5)), size = length(leader.direction);
    const auto by = [&] { return width * Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}; };
    for (int k = 0; k < 16; ++k) {
      Ray ray = leader;
      if (number % 3 != 0) ray.origin = ray.origin + by();
      if (k != 0) ray.direction = ray.direction + size * by();
      if (number % 7 == 0 && k == 5) ray.direction = -ray.direction;
      rays.push_back(given(ray));
    }
  }
  return rays;
}

/// As many rays again, which continue from the hits of the first ones.
void add_departing(std::vector<GivenRay>& rays, const std::vector<FoundHit>& hits) {
  for (std::size_t i = 0; i < hits.size(); ++i) {
    if (hits[i].kind < 0) continue;
    GivenRay ray = rays[i];
    const double d = std::hypot(ray.d[0], ray.d[1], ray.d[2]);
    // t counts in units of the prepared direction, whose length is between 1 and 2.
    const double unit = std::exp2(std::floor(std::log2(d)));
    for (std::size_t k = 0; k < 3; ++k) ray.o[k] += hits[i].t * ray.d[k] / unit;
    ray.t_min = 0;
    ray.departed = hits[i].id;
    rays.push_back(ray);
  }
}

struct Tally {
  std::size_t rays = 0, hits = 0, differing = 0, any_differing = 0;
};

void compare(const PacketTier& tier, int lanes, FindHits packets, const std::string& shape, Acceleration acceleration,
             Tally& tally) {
  SceneMaker maker(77);
  maker.add(shape, 12);
  const PackedScene<float> narrow = packed_for(maker.scene(), 1, acceleration),
                           wide = packed_for(maker.scene(), lanes, acceleration);
  std::vector<GivenRay> rays = bundles(maker, 2048);
  add_departing(rays, tier.alone(buffers_of(narrow), rays, false));
  const auto expected = tier.alone(buffers_of(narrow), rays, false), found = packets(buffers_of(wide), rays, false),
             any = packets(buffers_of(wide), rays, true);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const bool is_hit = expected[i].kind >= 0;
    const bool same = found[i].kind == expected[i].kind &&
                      (!is_hit || (found[i].id == expected[i].id && found[i].t == expected[i].t));
    if (!same && tally.differing == 0)
      UNSCOPED_INFO("ray " << i << " of " << rays.size() << " departed " << rays[i].departed << ": id " << found[i].id
                           << " t " << found[i].t << ", alone id " << expected[i].id << " t " << expected[i].t);
    ++tally.rays;
    tally.hits += is_hit;
    tally.differing += !same;
    tally.any_differing += (any[i].kind >= 0) != is_hit;
  }
}

TEST_CASE("every shape of the list is there for packets") {
  for (std::size_t kind = 0; kind < shape_entries.size(); ++kind) {
    INFO(shape_entries[kind]);
    SceneMaker maker(1);
    maker.add(shape_of(shape_entries[kind]), 1);
    const PackedScene<float> packed = packed_for(maker.scene(), 1, Acceleration::list);
    const std::size_t row = layout::HEADER_INTS + kind * layout::SHAPE_INTS;
    CHECK(packed.index.at(row + layout::SHAPE_BLOCKS) > 0);
  }
}

TEST_CASE("rays in packets find what each finds alone, to the bit") {
  for (const PacketTier& tier : {packets_stable(), packets_robust()})
    for (const auto& [lanes, packets] : tier.packets)
      for (const std::string& entry : shape_entries)
        for (const Acceleration acceleration : {Acceleration::list, Acceleration::tree}) {
          INFO(tier.name << ", " << lanes << " lanes, " << entry
                         << (acceleration == Acceleration::list ? ", list" : ", tree"));
          Tally tally;
          compare(tier, lanes, packets, shape_of(entry), acceleration, tally);
          CHECK(tally.differing == 0);
          CHECK(tally.hits > tally.rays / 8);
          CHECK(tally.any_differing == 0);
        }
}

TEST_CASE("lanes without a path are not walked") {
  SceneMaker maker(5);
  maker.add("mesh", 12);
  const GivenRay ray{{0, 0, -50}, {0.01, 0.02, 1}, 0, 1000};
  for (const PacketTier& tier : {packets_stable(), packets_robust()})
    for (const auto& [lanes, walked] : tier.walked) {
      const PackedScene<float> packed = packed_for(maker.scene(), lanes, Acceleration::tree);
      const unsigned all = (1u << lanes) - 1u;
      for (const unsigned alive : {0u, 1u, 0x5au, all >> 1, all}) {
        INFO(tier.name << ", " << lanes << " lanes, alive " << alive);
        const auto [unmade, left_over] = walked(buffers_of(packed), ray, alive);
        CHECK(unmade == alive);
        CHECK(left_over == alive);
      }
    }
}

}  // namespace
