// SPDX-License-Identifier: MIT
// A group that is placed is what its shapes would be there: the same hits, bit for bit where the map is exact; with and
// without trees, at every width. What decides equal t, what a ray has left, mirrored and distorted groups.
#include "cl/instanced_scenes.h"
#include "cl/same_bits.h"
#include "support/devices.h"

using namespace strahl;
using namespace strahl::test;

namespace {

Device device() {
  require_pocl_and_rusticl();
  return Device::open("pocl");
}

RenderSettings settings_of(Precision precision, int width, Acceleration acceleration) {
  RenderSettings settings;
  settings.precision = precision;
  settings.bvh_width = width;
  settings.acceleration = acceleration;
  return settings;
}

Vec3 whole(oracle::Random& random) {
  const auto step = [&] { return 4.0 * random.integer(-8, 8); };
  return {step(), step(), step()};
}

/// Origins on a grid that translations keep, so that nothing is rounded but what the flat scene rounds too.
std::vector<Ray> on_grid(std::vector<Ray> rays) {
  for (Ray& ray : rays) {
    const auto round = [](double x) { return std::nearbyint(16 * x) / 16; };
    ray.origin = {round(ray.origin.x), round(ray.origin.y), round(ray.origin.z)};
  }
  return rays;
}

double distance(const Vec3& a, const Vec3& b) { return length(a - b); }

}  // namespace

TEST_CASE("Instances that are only moved are hit as their shapes would be, bit for bit") {
  InstancedMaker maker(7);
  const Scene scene = maker.scene(40, [&](int) { return moved_by(whole(maker.random())); });
  const Scene flat = flattened(scene);
  const std::vector<Ray> rays = on_grid(maker.rays(40000));
  for (const Precision precision : {Precision::robust, Precision::fp64}) {
    const auto expected = Intersector(device(), flat, settings_of(precision, 4, Acceleration::tree)).trace(rays);
    const auto hits = Intersector(device(), scene, settings_of(precision, 8, Acceleration::tree)).trace(rays);
    int instanced = 0, others = 0, differing = 0;
    double off = 0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      (hits[i].instance >= 0 ? instanced : others) += hits[i].shape >= 0;
      const bool same = hits[i].t == expected[i].t && hits[i].primitive == expected[i].primitive &&
                        flat_shape(scene, hits[i]) == expected[i].shape && hits[i].u == expected[i].u &&
                        hits[i].v == expected[i].v;
      differing += !same;
      if (!same && differing < 5)
        UNSCOPED_INFO(i << ": " << hits[i].instance << " " << flat_shape(scene, hits[i]) << "/" << hits[i].primitive
                        << " t " << hits[i].t << " u " << hits[i].u << " v " << hits[i].v << ", flat "
                        << expected[i].shape << "/" << expected[i].primitive << " t " << expected[i].t << " u "
                        << expected[i].u << " v " << expected[i].v);
      if (hits[i].shape >= 0 && expected[i].shape >= 0)
        off = std::max(off, distance(hits[i].normal, expected[i].normal));
    }
    INFO(precision_name(precision));
    CHECK(differing == 0);
    CHECK(instanced > 10000);
    CHECK(others > 1000);
    CHECK(off < (precision == Precision::fp64 ? 0x1p-50 : 0x1p-21));
  }
}
