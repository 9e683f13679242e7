// SPDX-License-Identifier: MIT
// Embree as a peer: every kind of shape, single rays and packets, the same answers as strahl's. 5 s.
#include <catch2/catch.hpp>

#include "bench/peers/embree.h"
#include "bench/peers/embree_tree.h"
#include "bench/race.h"
#include "bench/strahl_contender.h"
#include "study/generated/scenes.h"
#include "support/devices.h"

namespace strahl::test {
namespace {

using namespace strahl::bench;

Scene every_shape() {
  Scene scene = ten_spheres();
  scene.film.width = scene.film.height = 72;  // Not a multiple of a packet of tiles.
  const auto add = [&scene](const Geometry& geometry) { scene.shapes.emplace_back().geometry = geometry; };
  add(Box{{-1, 1.25, -1}, {0, 2, 0.5}});
  add(Rectangle{{1, 1, 0}, {1, 0.25, 0}, {0, 1, 0.5}});
  add(Triangle{{-2, 1, 1}, {-1, 1.5, 1}, {-2, 2.5, 0}});
  add(Cube{{0.5, 2, -1}, {{{1, 0, 0.25}, {0, 1, 0}, {-0.25, 0, 1}}}});
  const Scene pyramid = tetra(2);
  add(pyramid.shapes[0].geometry);
  return scene;
}

TEST_CASE("Embree answers as strahl does, whatever it is asked") {
  require_pocl();
  REQUIRE(has_embree());
  const Scene scene = every_shape();
  const Device device = Device::open("pocl");
  std::vector<std::unique_ptr<Contender>> contenders;
  contenders.push_back(std::make_unique<StrahlContender>(device, scene, RenderSettings{}));
  for (const bool robust : {false, true})
    for (const EmbreeSettings& settings :
         {EmbreeSettings{robust, 1, false, 2}, {robust, 1, true, 1}, {robust, 8, true, 3}, {robust, 16, true, 2}})
      contenders.push_back(embree_contender(scene, settings));
  auto& strahl = dynamic_cast<StrahlContender&>(*contenders[0]);
  const RaySet primary = primary_rays(scene);
  strahl.load(primary);
  static_cast<void>(strahl.trace());
  const std::vector<Hit> hits = strahl.hits();
  for (const RaySet& set : {primary, shadow_rays(scene, primary, hits), diffuse_rays(primary, hits)}) {
    const Race result = race(contenders, set, 1);
    INFO(result.kind);
    CHECK(result.entries[0].hits > set.rays.size() / 50);
    for (const Entry& entry : result.entries) {
      INFO(entry.program << " " << entry.variant);
      CHECK(entry.differing <= 5);  // Rays at an edge; of 5184.
      CHECK(entry.seconds[0] > 0);
    }
  }
}

TEST_CASE("Embree's builder is a yardstick for strahl's") {
  require_pocl();
  const Device device = Device::open("pocl");
  for (const Scene& scene : {sphereflake(3), terrain(20000), box_lattice(10), tetra(5)}) {
    INFO(scene.name);
    const RunStats stats = Intersector(device, scene).stats();
    const double ours = stats.tree.sah_cost;
    const auto block = static_cast<unsigned>(stats.lanes);
    const PeerTree peer = embree_tree(scene, false, 2, block);
    CHECK(peer.seconds > 0);
    CHECK(ours > 1);
    CHECK(ours < 1.05 * peer.sah_cost);
    CHECK(embree_tree(scene, true, 2, block).sah_cost < 1.05 * peer.sah_cost);
  }
}

TEST_CASE("Embree refuses what it lacks") {
  Scene scene;
  scene.shapes.emplace_back().geometry = Disk{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  CHECK_THROWS_WITH(embree_contender(scene, {}), Catch::Contains("spheres, planes"));
  CHECK_THROWS_WITH(embree_contender(ten_spheres(), {false, 5, true, 1}), Catch::Contains("not 5"));
}

}  // namespace
}  // namespace strahl::test
