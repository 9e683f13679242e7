// SPDX-License-Identifier: MIT
// Rays to measure with: floats, in tiles, from where the camera's rays ended. 1 s.
#include <algorithm>
#include <catch2/catch.hpp>

#include "study/generated/scenes.h"
#include "study/generated/stage.h"
#include "study/ray_sets.h"
#include "support/devices.h"

namespace strahl::test {
namespace {

Scene small(Scene scene, int width, int height) {
  scene.film.width = width;
  scene.film.height = height;
  return scene;
}

bool is_float(const Vec3& v) { return v == to_float(v); }

TEST_CASE("every pixel once, 16 in a row are neighbours") {
  Scene scene = small(ten_spheres(), 36, 20);
  scene.camera.projection = Projection::orthographic;
  scene.camera.world_from_camera = Transform{{{{-18, 0, 0, 0}, {0, 18, 0, 0}, {0, 0, -1, 0}}}};
  const RaySet set = primary_rays(scene);
  REQUIRE(set.rays.size() == 36 * 20);
  std::vector<std::pair<double, double>> places;
  for (const Ray& ray : set.rays) places.emplace_back(ray.origin.x, ray.origin.y);
  CHECK(places[0] == std::pair(-17.5, 9.5));
  for (std::size_t i = 0; i < 256; ++i) {
    CHECK(places[i].first < -18 + 16);
    CHECK(std::abs(places[i].first - places[i / 16 * 16].first) < 4);
    CHECK(std::abs(places[i].second - places[i / 16 * 16].second) < 4);
  }
  std::sort(places.begin(), places.end());
  CHECK(std::adjacent_find(places.begin(), places.end()) == places.end());
}

TEST_CASE("shadow rays end at the lamp, bounces leave by the cosine law") {
  require_pocl();
  const Scene scene = small(ten_spheres(), 64, 64);
  const RaySet primary = primary_rays(scene);
  Intersector intersector(Device::open("pocl"), scene);
  const std::vector<Hit> hits = intersector.trace(primary.rays);
  const auto met =
      static_cast<std::size_t>(std::count_if(hits.begin(), hits.end(), [](const Hit& hit) { return hit.shape >= 0; }));
  REQUIRE(met > 3000);

  const RaySet shadow = shadow_rays(scene, primary, hits);
  CHECK(shadow.any_hit());
  CHECK(shadow.rays.size() == met);
  const Vec3 lamp = std::get<PointLight>(scene.lights[0].emitter).position;
  for (const Ray& ray : shadow.rays) {
    CHECK(length(ray.origin + ray.t_max * ray.direction - lamp) < 0x1p-22 * length(ray.direction));
    CHECK((is_float(ray.origin) && is_float(ray.direction)));
  }

  const RaySet diffuse = diffuse_rays(primary, hits);
  REQUIRE(diffuse.rays.size() == met);
  double cosines = 0;
  std::size_t k = 0;
  for (const Hit& hit : hits) {
    if (hit.shape < 0) continue;
    const Ray& ray = diffuse.rays[k++];
    CHECK((is_float(ray.origin) && is_float(ray.direction)));
    cosines += std::abs(dot(ray.direction, hit.normal));
  }
  CHECK(cosines / static_cast<double>(met) == Approx(2.0 / 3).margin(0.015));  // Standard error 0.004.
  const std::vector<Hit> again = intersector.trace(diffuse.rays);
  CHECK(std::count_if(again.begin(), again.end(), [](const Hit& hit) { return hit.t < 0x1p-10; }) == 0);
}

TEST_CASE("no lamp, no shadow rays") {
  Scene scene = small(ten_spheres(), 1, 1);
  scene.lights.clear();
  CHECK_THROWS_WITH(shadow_rays(scene, primary_rays(scene), {Hit{}}), Catch::Contains("point light"));
}

}  // namespace
}  // namespace strahl::test
