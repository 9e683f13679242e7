// SPDX-License-Identifier: MIT
// From inside a closed surface, at its shared edges and vertices: exactly one primitive is hit. Leaks show as misses;
// double hits by tracing again with the first one left out.
#include <catch2/catch.hpp>

#include "cl/host_tracer.h"
#include "selftest/closed_meshes.h"
#include "support/devices.h"

using namespace strahl;
using namespace strahl::selftest;
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

}  // namespace

TEMPLATE_TEST_CASE("exactly one hit from inside, on the host", "", float, double) {
  for (const auto& [name, surface] : closed_surfaces()) {
    INFO(name);
    const HostTracer<TestType> host(surface.scene, 8);
    require_exactly_one_hit(surface, ray_count / 5, [&](const std::vector<Ray>& rays) { return host.trace(rays); });
  }
}

TEST_CASE("exactly one hit from inside, on PoCL") {
  require_pocl();
  const Device device = Device::open("pocl");
  for (const auto& [name, surface] : closed_surfaces()) {
    INFO(name);
    Intersector intersector(device, surface.scene);
    require_exactly_one_hit(surface, ray_count, [&](const std::vector<Ray>& rays) { return intersector.trace(rays); });
  }
}
