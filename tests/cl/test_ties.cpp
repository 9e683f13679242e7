// SPDX-License-Identifier: MIT
// Primitives of different kinds that are hit at the very same t: the lowest id wins, whatever the order of the kinds'
// lists, of blocks and of lanes. And what fills up the last block of a list, points at the origin, is never hit.
#include <algorithm>
#include <catch2/catch.hpp>

#include "cl/host_tracer.h"
#include "support/devices.h"

using namespace strahl;
using namespace strahl::test;

namespace {

/// All of them have the point `at` in common, where their tangent plane is perpendicular to x.
std::vector<Geometry> touching(const Vec3& at) {
  const auto point = [&](double x, double y, double z) { return at + Vec3{x, y, z}; };
  Sphere sphere;
  sphere.center = point(2, 0, 0);
  sphere.radius = 2;
  return {sphere,
          Plane{at, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
          Box{point(0, -1, -1), point(2, 1, 1)},
          Triangle{point(0, -2, -2), point(0, 2, -2), point(0, 0, 4)},
          Rectangle{point(0, -1, -1), {0, 2, 0}, {0, 0, 2}},
          Disk{at, {0, 1, 0}, {0, 0, 1}},
          Cylinder{point(2, 0, -1), point(2, 0, 1), 2, {1, 0, 0}}};
}

std::vector<Geometry> touching() { return touching({0, 0, 0}); }

/// Each kind twenty times, all of one kind after all of another, from `first` on.
Scene scene_from(std::size_t first) {
  std::vector<Geometry> shapes = touching();
  std::rotate(shapes.begin(), shapes.begin() + static_cast<std::ptrdiff_t>(first), shapes.end());
  Scene scene;
  scene.materials.emplace_back();
  for (const Geometry& shape : shapes)
    for (int i = 0; i < 20; ++i) scene.shapes.emplace_back().geometry = shape;
  return scene;
}

const Ray along_x{{-4, 0, 0}, {1, 0, 0}};

template <class Real>
void hold_on_host(std::initializer_list<int> widths) {
  for (std::size_t first = 0; first < touching().size(); ++first)
    for (const int lanes : widths) {
      const Scene scene = scene_from(first);
      INFO("first " << first << ", width " << lanes);
      const Hit hit = HostTracer<Real>(scene, lanes).trace(along_x);
      CHECK(hit.t == 4);
      CHECK(hit.shape == 0);
    }
}

}  // namespace

TEST_CASE("every kind is hit at the same t") {
  for (const Geometry& shape : touching()) {
    Scene scene;
    scene.shapes.emplace_back().geometry = shape;
    CHECK(HostTracer<float>(scene, 1).trace(along_x).t == 4);
    CHECK(HostTracer<double>(scene, 1).trace(along_x).t == 4);
  }
}

TEST_CASE("the lowest id wins, on the host") {
  hold_on_host<float>({1, 8, 16});
  hold_on_host<double>({1, 8});
}

TEST_CASE("padding is never hit, on the host") {
  const std::vector<Ray> at_origin = {{{1, 0, 0}, {-1, 0, 0}}, {{0, 0, 0}, {0, 1, 0}}, {{1, 2, 3}, {-1, -2, -3}}};
  for (const Geometry& shape : touching({100, 100, 100})) {
    Scene scene;
    scene.shapes.emplace_back().geometry = shape;
    for (const int lanes : {1, 8, 16})
      for (const Ray& ray : at_origin) {
        INFO("kind " << shape.index() << ", width " << lanes);
        CHECK(HostTracer<float>(scene, lanes).trace(ray).shape == -1);
        CHECK(HostTracer<float>(scene, lanes).trace(ray, true).t == INFINITY);
      }
  }
}

TEST_CASE("the lowest id wins, on PoCL") {
  require_pocl();
  const Device device = Device::open("pocl");
  RenderSettings settings;
  settings.generic = true;
  for (std::size_t first = 0; first < touching().size(); ++first) {
    const Scene scene = scene_from(first);
    INFO("first " << first);
    const Hit hit = Intersector(device, scene, settings).trace({along_x}).front();
    CHECK(hit.t == 4);
    CHECK(hit.shape == 0);
  }
}
