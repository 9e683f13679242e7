// SPDX-License-Identifier: MIT
// A lamp at a point that lies exactly on a surface lights the room, from the camera's end and from its own, wherever
// the room stands. And walls that surround a lamp hide it from paths that are joined through them.
#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "render/alike.h"
#include "render/stage.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

/// A turn whose entries are not floats.
Vec3 turned(const Vec3& v) {
  return {(2 * v.x - v.y + 2 * v.z) / 3, (2 * v.x + 2 * v.y - v.z) / 3, (-v.x + 2 * v.y + 2 * v.z) / 3};
}
Vec3 as_it_is(const Vec3& v) { return v; }

constexpr double room_height = 2.1;

/// A floor and a black ceiling, seen from below the ceiling. lamp: at a place, in a direction.
template <typename Lamp>
Scene room(Vec3 (*turn)(const Vec3&), const Lamp& lamp, double below) {
  Scene scene;
  scene.shapes.clear();
  const Vec3 x = turn({6, 0, 0}), y = turn({0, 6, 0});
  add(scene, Rectangle{turn({-3, -3, 0}), x, y});
  add(scene, Rectangle{turn({-3, -3, room_height}), y, x}, add(scene, Diffuse{{{0, 0, 0}}}));
  add(scene, lamp(turn({0.37, 0.21, room_height - below}), turn({0, 0, -1}), turn({1, 0, 0}), turn({0, 1, 0})));
  scene.camera = perspective_camera(turn({0.1, 0.2, 1.9}), turn({0, 0, 0}), turn({0, 1, 0}), 60);
  return scene;
}

double mean_of(const Scene& scene, const std::string& integrator) {
  const std::vector<double> mean = blocks_of(scene, integrator, 32).mean;
  return std::accumulate(mean.begin(), mean.end(), 0.0) / static_cast<double>(mean.size());
}

template <typename Lamp>
void hold_in_the_ceiling(const std::string& what, const Lamp& lamp) {
  INFO(what);
  for (auto* turn : {as_it_is, turned}) {
    const double expected = mean_of(room(turn, lamp, 1e-3), "path");
    REQUIRE(expected > 0.01);
    const Scene scene = room(turn, lamp, 0);
    for (const char* integrator : {"path", "ptracer", "bdpt"}) {
      INFO(integrator);
      CHECK(mean_of(scene, integrator) == Approx(expected).epsilon(0.02));
    }
  }
}

TEST_CASE("a lamp that lies in the ceiling") {
  require_pocl();
  hold_in_the_ceiling("point", [](const Vec3& place, const Vec3& /*down*/, const Vec3& /*x*/, const Vec3& /*y*/) {
    return PointLight{place, {10, 10, 10}};
  });
  hold_in_the_ceiling("spot", [](const Vec3& place, const Vec3& down, const Vec3& /*x*/, const Vec3& /*y*/) {
    return SpotLight{place, down, {10, 10, 10}, 40, 30, -1, {1, 0, 0}, {0, 1, 0}};
  });
  hold_in_the_ceiling("projector", [](const Vec3& place, const Vec3& down, const Vec3& x, const Vec3& y) {
    return ProjectorLight{place, {x, y, down}, 0.5, 0.5, {10, 10, 10}, -1};
  });
}

TEST_CASE("a shade around a lamp, in every tier") {
  require_pocl();
  Scene scene;
  scene.shapes.clear();
  add(scene, Sphere{{0, 0, 0}, 1}, add(scene, Diffuse{{{0.8, 0.8, 0.8}}}, true));
  add(scene, Rectangle{{-3, -3, -1.5}, {6, 0, 0}, {0, 6, 0}});
  add(scene, PointLight{{0, 0, 0}, {10, 10, 10}});
  scene.camera = perspective_camera({0, -5, 1}, {0, 0, -1}, {0, 0, 1}, 40);
  scene.film.width = scene.film.height = 32;
  scene.sampler.sample_count = 16;
  scene.integrator.name = "bdpt";
  for (const Precision tier : {Precision::fast, Precision::robust}) {
    RenderSettings settings;
    settings.precision = tier;
    const Image image = render("pocl", scene, settings).color;
    CAPTURE(precision_name(tier));
    // Of `fast`, rays that begin off the wall by an epsilon get out at a shallow angle.
    CHECK(std::ranges::max(image.data) < (tier == Precision::fast ? 0.001F : 1e-30F));
  }
}

}  // namespace
}  // namespace strahl::test
