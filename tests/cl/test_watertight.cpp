// SPDX-License-Identifier: MIT
// From inside a closed surface, at its shared edges and vertices: exactly one primitive is hit. Leaks show as misses;
// double hits by tracing again with the first one left out.
#include <catch2/catch.hpp>

#include "cl/closed_meshes.h"
#include "cl/host_tracer.h"
#include "support/devices.h"

using namespace strahl;
using namespace strahl::test;

namespace {

constexpr std::size_t ray_count = 100000;

template <class Trace>
void require_exactly_one_hit(const ClosedSurface& surface, std::size_t count, Trace trace) {
  std::vector<Ray> rays = rays_at_seams(surface, count, 5);
  const std::vector<Hit> hits = trace(rays);
  int leaks = 0, doubles = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    leaks += hits[i].shape < 0;
    rays[i].shape = hits[i].shape;
    rays[i].primitive = hits[i].primitive;
  }
  // The flat primitive that a ray has left is not hit anywhere, so whatever is hit now was hit as well.
  for (const Hit& hit : trace(rays)) doubles += hit.shape >= 0;
  CHECK(leaks == 0);
  CHECK(doubles == 0);
}

const Vec3 far_away{1e6, -1e6, 1e6};

std::vector<std::pair<std::string, ClosedSurface>> surfaces() {
  const ClosedSurface axes = room({{-3, -2, -5}, {{{8, 0, 0}, {0, 4, 0}, {0, 0, 6}}}});
  const ClosedSurface sheared = room({{0.1, 0.2, 0.3}, {{{1, 0.3, -0.2}, {0.1, 1.3, 0.25}, {-0.3, 0.2, 0.9}}}});
  const ClosedSurface far_room = room({far_away, {{{100.7, 0.3, 0.2}, {1.1, 60.3, 0.2}, {-0.3, 0.2, 80.1}}}});
  return {{"icosphere", icosphere({0, 0, 0}, 2, 2)},
          {"icosphere, 10^6 away", icosphere(far_away, 100, 2)},
          {"tiny icosphere", icosphere({0, 0, 0}, 1e-6, 1)},
          {"room along the axes", axes},
          {"its triangles", triangulated(axes)},
          {"sheared room", sheared},
          {"its triangles", triangulated(sheared)},
          {"room 10^6 away", far_room},
          {"its triangles", triangulated(far_room)}};
}

}  // namespace

TEMPLATE_TEST_CASE("exactly one hit from inside, on the host", "", float, double) {
  for (const auto& [name, surface] : surfaces()) {
    INFO(name);
    const HostTracer<TestType> host(surface.scene, 8);
    require_exactly_one_hit(surface, ray_count / 5, [&](const std::vector<Ray>& rays) { return host.trace(rays); });
  }
}

TEST_CASE("exactly one hit from inside, on PoCL") {
  require_pocl_and_rusticl();
  const Device device = Device::open("pocl");
  for (const auto& [name, surface] : surfaces()) {
    INFO(name);
    Intersector intersector(device, surface.scene);
    require_exactly_one_hit(surface, ray_count, [&](const std::vector<Ray>& rays) { return intersector.trace(rays); });
  }
}
