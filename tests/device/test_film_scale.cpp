// SPDX-License-Identifier: MIT
// The film's unit: a power of two that follows the brightness of a scene.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "device/pack.h"
#include "scene/build.h"

using namespace strahl;

namespace {

constexpr double unit = 0x1p28;  // units in a radiance of 1

Scene glowing(double radiance) {
  Scene scene;
  add(scene, emitting(Sphere{}, {0, radiance, radiance / 3}));
  return scene;
}

Scene lit(const decltype(Light::emitter)& emitter) {
  Scene scene;
  add(scene, Box{{-1, -1, -1}, {1, 1, 1}});
  add(scene, emitter);
  return scene;
}

}  // namespace

TEST_CASE("The scale is a power of two, within a factor 2 of its aim, and never grows with the radiance") {
  double last = std::numeric_limits<double>::infinity();
  for (double radiance = 1e-15; radiance < 1e15; radiance *= 1.37) {
    const double scale = film_scale(glowing(radiance));
    int exponent = 0;
    CHECK(std::frexp(scale, &exponent) == 0.5);
    CHECK(scale * radiance >= unit);
    CHECK(scale * radiance < 2 * unit);
    CHECK(scale <= last);
    last = scale;
  }
}

TEST_CASE("A picture twice as bright has half the scale") {
  for (const double radiance : {0.003, 0.7, 1.0, 42.0})
    CHECK(film_scale(glowing(2 * radiance)) == film_scale(glowing(radiance)) / 2);
}

TEST_CASE("The scale is finite in single precision and has a finite inverse") {
  for (const double radiance : {std::numeric_limits<double>::max(), std::numeric_limits<double>::denorm_min()}) {
    const auto scale = static_cast<float>(film_scale(glowing(radiance)));
    CHECK(scale >= 0x1p-100F);
    CHECK(scale <= 0x1p100F);
  }
}

TEST_CASE("The brightest source decides") {
  Scene scene = glowing(1);
  add(scene, emitting(Sphere{}, {0, 0, 64}));
  CHECK(film_scale(scene) == unit / 64);

  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.parts = {{0, Rgb{1024, 0, 0}}};
  mesh.part_of_triangle = {0};
  add(scene, mesh);
  CHECK(film_scale(scene) == unit / 1024);
}

TEST_CASE("Lights count by what a white surface in the scene's middle reflects") {
  CHECK(film_scale(lit(ConstantLight{{8, 1, 1}})) == unit / 8);
  CHECK(film_scale(lit(DirectionalLight{{0, 0, 1}, {1, 16, 1}})) == unit / 16);
  CHECK(film_scale(lit(PointLight{{0, 8, 0}, {0, 0, 64 * 32}})) == unit / 32);
  // Nearer than half the scene's size, that size counts: a light in the middle is not infinitely bright.
  CHECK(film_scale(lit(PointLight{{0, 0, 0}, {4 * 3.5, 0, 0}})) == unit / 4);
  // Where nothing is bounded the nearest plane is what the light shines on; no plane, nothing to shine on.
  Scene planes;
  add(planes, PointLight{{0, 10, 0}, {256, 256, 256}});
  CHECK(film_scale(planes) == unit);
  add(planes, Plane{{5, 6, 7}, {0, 3, 0}, {1, 0, 0}, {0, 0, -1}});
  add(planes, Plane{{5, -90, 7}, {0, 1, 0}, {1, 0, 0}, {0, 0, -1}});
  CHECK(film_scale(planes) == unit / 16);
}

TEST_CASE("Pictures of something else than light have a scale of their own") {
  CHECK(film_scale(Scene{}) == unit);
  Scene scene = glowing(1000);
  scene.integrator.name = "normals";
  CHECK(film_scale(scene) == unit);

  Scene depth;
  depth.integrator.name = "depth";
  CHECK(film_scale(depth) == unit);
  add(depth, Box{{0, 0, 0}, {2, 3, 6}});  // diagonal 7
  depth.camera = perspective_camera({1, 1.5, 3 + 60}, {1, 1.5, 3}, {0, 1, 0}, 40);
  CHECK(film_scale(depth) == unit / 64);  // 7 + 60
}
