// SPDX-License-Identifier: MIT
// strict_normals: light comes to a smooth mesh where its two normals agree about the side that it comes from, and is
// seen where they agree about the side of the view.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "render/alike.h"
#include "render/stage.h"

namespace strahl::test {
namespace {

/// A triangle across the stage that faces the camera, as if it were tilted by 60 degrees about y.
Mesh leaning() {
  const Vec3 normal{std::sqrt(0.75), 0, 0.5};
  Mesh mesh;
  mesh.positions = {{-20, -20, 0}, {20, -20, 0}, {0, 20, 0}};
  mesh.triangles = {{0, 1, 2}};
  mesh.normals = {normal, normal, normal};
  return mesh;
}

Scene scene_of(const char* integrator, const Light& lit, bool is_strict) {
  Scene scene = stage({leaning()}, diffuse({1, 1, 1}, true));
  scene.film.width = scene.film.height = 8;
  scene.sampler = {};
  scene.sampler.sample_count = 256;
  scene.lights = {lit};
  scene.integrator.name = integrator;
  scene.integrator.strict_normals = is_strict;
  return scene;
}

double mean_radiance(const Image& image) {
  double sum = 0;
  for (const float value : image.data) sum += double{value};
  return sum / static_cast<double>(image.data.size());
}

const char* const integrators[] = {"direct", "path", "whitted", "volpath"};

}  // namespace

TEST_CASE("light from behind a triangle does not reach its front") {
  const Vec3 way = normalized({-1, 0, 0.2});  // From below; the interpolated normal faces it.
  const double cosine = dot(-way, leaning().normals[0]), irradiance = std::numbers::pi;
  const Light behind = light(DirectionalLight{way, {irradiance, irradiance, irradiance}});
  const Light before = light(DirectionalLight{{0, 0, -1}, {irradiance, irradiance, irradiance}});
  for (const char* integrator : integrators)
    for (const Precision precision : {Precision::robust, Precision::fp64}) {
      INFO(integrator);
      CHECK(mean_radiance(color(scene_of(integrator, behind, false), precision)) == Approx(cosine).epsilon(1e-4));
      CHECK(mean_radiance(color(scene_of(integrator, behind, true), precision)) == 0);
      CHECK(mean_radiance(color(scene_of(integrator, before, true), precision)) == Approx(0.5).epsilon(1e-4));
    }
}

TEST_CASE("of an even sky what is before the triangle and before its normal alike") {
  // The cosine of a half sphere's directions to its pole, over those within a wedge of two planes at 60 degrees.
  const double share = (1 + 0.5) / 2;
  const Light sky = light(ConstantLight{{1, 1, 1}});
  for (const char* integrator : integrators) {
    INFO(integrator);
    CHECK(mean_radiance(color(scene_of(integrator, sky, false), Precision::robust)) == Approx(1).margin(0.01));
    CHECK(mean_radiance(color(scene_of(integrator, sky, true), Precision::robust)) == Approx(share).margin(0.01));
  }
}

TEST_CASE("what is seen from one side by one normal and from the other by the other is black") {
  Scene scene = scene_of("path", light(ConstantLight{{1, 1, 1}}), false);
  // From the triangle's front, 75 degrees off its normal and 135 off the interpolated one.
  const double angle = 75 * std::numbers::pi / 180, sine = std::sin(angle), cosine = std::cos(angle);
  scene.camera.world_from_camera.m = {{{cosine, 0, sine, -40 * sine}, {0, 1, 0, 0}, {sine, 0, -cosine, 40 * cosine}}};
  CHECK(mean_radiance(color(scene, Precision::robust)) > 0.2);
  scene.integrator.strict_normals = true;
  CHECK(mean_radiance(color(scene, Precision::robust)) == 0);
}

TEST_CASE("paths from the light, and from both ends, keep to the same sides") {
  // An open sheet over a floor, whose normals lean to all sides, with a lamp above it, one below, and one that
  // lights the floor.
  Mesh mesh;
  mesh.positions = {{-1.5, -1.5, 1}, {1.5, -1.5, 1}, {1.5, 1.5, 1}, {-1.5, 1.5, 1}};
  mesh.normals = {normalized({-2, -2, 1}), normalized({2, -2, 1}), normalized({2, 2, 1}), normalized({-2, 2, 1})};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  Scene scene;
  scene.materials = {diffuse({0.8, 0.8, 0.8}, true)};
  add(scene, Rectangle{{-3, -3, 0}, {6, 0, 0}, {0, 6, 0}});
  add(scene, mesh);
  add(scene, emitting(Rectangle{{-3, -1, 3}, {0, 2, 0}, {2, 0, 0}}, {0.5, 0.5, 0.5}));
  add(scene, emitting(Rectangle{{1, -1, 0.1}, {2, 0, 0}, {0, 2, 0}}, {4, 4, 4}));
  add(scene, emitting(Rectangle{{1.6, -3, 0.9}, {0, 4, 0}, {2, 0, 0}}, {16, 16, 16}));
  scene.camera = perspective_camera({0, -5, 3}, {0, 0, 0.8}, {0, 0, 1}, 40);
  scene.film.filter = {FilterKind::box, 0.5, 0.5};
  scene.integrator.max_depth = 5;
  const std::vector<double> loose = blocks_of(scene, "path", 16).mean;
  scene.integrator.strict_normals = true;
  const std::vector<double> strict = blocks_of(scene, "path", 16).mean;
  for (const std::size_t on_sheet : {5, 6}) CHECK(strict.at(on_sheet) < 0.98 * loose.at(on_sheet));
  for (const char* integrator : {"ptracer", "bdpt"}) hold_alike(integrator, "path", integrator, scene, 128, 0.01);
}

TEST_CASE("a program of the scene's own draws the same as the generic one") {
  const Scene scene = scene_of("path", light(ConstantLight{{1, 1, 1}}), true);
  RenderSettings own = all_aovs();
  CHECK(same_bits(render("pocl", scene, own).color, color(scene, Precision::robust)));
}

}  // namespace strahl::test
