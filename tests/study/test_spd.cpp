// SPDX-License-Identifier: MIT
// E. Haines' Standard Procedural Databases as others know them: the generated ones are the same as the files, and the
// rays through the corners of 512 x 512 pixels hit as often as published. 6 s.
#include <algorithm>
#include <catch2/catch.hpp>
#include <numbers>

#include "render/intersector.h"
#include "study/generated/scenes.h"
#include "support/devices.h"
#include "support/needs.h"
#include "support/nff.h"

namespace strahl::test {
namespace {

const std::string folder = STRAHL_SOURCE_DIR "/../shared/data/spd/";
const Needs needs(folder + "balls.nff");

Scene scene_of(const Nff& nff) {
  Scene scene;
  for (const Sphere& sphere : nff.spheres) scene.shapes.emplace_back().geometry = sphere;
  for (const std::vector<Vec3>& polygon : nff.polygons)
    for (std::size_t i = 2; i < polygon.size(); ++i)
      scene.shapes.emplace_back().geometry = Triangle{polygon[0], polygon[i - 1], polygon[i]};
  return scene;
}

std::vector<Ray> corner_rays(const Nff& nff) {
  const Vec3 forward = normalized(nff.at - nff.from);
  const Vec3 right = normalized(cross(forward, nff.up));
  const Vec3 up = cross(right, forward);
  const double tangent = std::tan(nff.fov_degrees * std::numbers::pi / 360);
  std::vector<Ray> rays;
  for (int y = 0; y <= nff.resolution; ++y)
    for (int x = 0; x <= nff.resolution; ++x) {
      const double sx = tangent * (2.0 * x / nff.resolution - 1), sy = tangent * (1 - 2.0 * y / nff.resolution);
      rays.push_back({nff.from, forward + sx * right + sy * up});
    }
  return rays;
}

long hits(const std::string& name) {
  const Nff nff = read_nff(folder + name);
  Intersector intersector(Device::open("pocl"), scene_of(nff));
  const std::vector<Hit> all = intersector.trace(corner_rays(nff));
  return std::count_if(all.begin(), all.end(), [](const Hit& hit) { return hit.shape >= 0; });
}

TEST_CASE("published counts of rays that hit") {
  require_pocl();
  CHECK(hits("balls.nff") == 263169);
  CHECK(hits("tetra.nff") == 49950);
  CHECK(hits("teapot_s12.nff") == 161546);
}

TEST_CASE("the generated sphereflake is SPD's balls") {
  const Nff nff = read_nff(folder + "balls.nff");
  const Scene scene = sphereflake(4);
  REQUIRE(scene.shapes.size() == nff.spheres.size() + nff.polygons.size());
  int wrong = 0;
  for (std::size_t i = 0; i < nff.spheres.size(); ++i) {
    const auto& sphere = std::get<Sphere>(scene.shapes[i + 1].geometry);
    wrong +=
        length(sphere.center - nff.spheres[i].center) > 1e-5 || std::abs(sphere.radius - nff.spheres[i].radius) > 1e-5;
  }
  CHECK(wrong == 0);
}

TEST_CASE("the generated tetra is SPD's") {
  const Nff nff = read_nff(folder + "tetra.nff");
  const Scene scene = tetra(6);
  const auto& mesh = std::get<Mesh>(scene.shapes[0].geometry);
  using Corners = std::array<std::array<double, 3>, 3>;
  const auto sorted_corners = [](const Vec3& a, const Vec3& b, const Vec3& c) {
    Corners corners{{{a.x, a.y, a.z}, {b.x, b.y, b.z}, {c.x, c.y, c.z}}};
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  std::vector<Corners> ours, theirs;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto at = [&mesh](int i) { return mesh.positions[static_cast<std::size_t>(i)]; };
    ours.push_back(sorted_corners(at(a), at(b), at(c)));
  }
  for (const std::vector<Vec3>& p : nff.polygons) theirs.push_back(sorted_corners(p[0], p[1], p[2]));
  std::sort(ours.begin(), ours.end());
  std::sort(theirs.begin(), theirs.end());
  CHECK(ours == theirs);
}

}  // namespace
}  // namespace strahl::test
