// SPDX-License-Identifier: MIT
// Mirrors in closed form: exact radiance, sides, depth, what is hidden, and no change where there is no mirror.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "render/limitations.h"
#include "render/stage.h"

namespace strahl::test {
namespace {

Material mirror(const Rgb& reflectance, bool twosided = false) {
  Material material;
  material.bsdf = Conductor{{reflectance}};
  material.twosided = twosided;
  return material;
}

Shape glowing(const Geometry& geometry, const Rgb& radiance) {
  Shape shape;
  shape.geometry = geometry;
  shape.radiance = radiance;
  return shape;
}

/// Turns the stage's rays, which come along -z, to +x.
Plane slanted() { return {{0, 0, 0}, {1, 0, 1}, {0, 1, 0}, {1, 0, -1}}; }
/// Faces them then.
Rectangle wall() { return {{50, -50, -50}, {0, 0, 100}, {0, 100, 0}}; }

Scene whitted(const std::vector<Geometry>& shapes, const Material& material) {
  Scene scene = stage(shapes, material);
  scene.integrator.name = "whitted";
  return scene;
}

void require_all(const Image& image, const std::array<float, 3>& expected) {
  for (std::size_t i = 0; i < image.data.size(); ++i) REQUIRE(image.data[i] == expected.at(i % 3));
}

TEST_CASE("a mirror shows an emitter's radiance times its reflectance, exactly") {
  require_pocl();
  Scene scene = whitted({slanted()}, mirror({1, 0.5, 0.25}));
  scene.shapes.push_back(glowing(wall(), {3, 1.75, 0.125}));
  for (const Precision precision : asked_tiers()) require_all(color(scene, precision), {3, 1.75F / 2, 0.125F / 4});
  scene.shapes.back().flip_normals = !scene.shapes.back().flip_normals;  // Its back does not glow.
  CHECK(lit_pixels(color(scene)) == 0);
}

TEST_CASE("two mirrors: their reflectances multiply") {
  require_pocl();
  // To the right, then up again, where the light is.
  Scene scene = whitted({slanted(), Plane{{10, 0, 0}, {-1, 0, 1}, {0, 1, 0}, {1, 0, 1}}}, mirror({0.5, 0.25, 1}));
  scene.materials.push_back(diffuse({0, 0, 0}));
  scene.shapes.push_back(glowing(Rectangle{{-50, -50, 60}, {0, 100, 0}, {100, 0, 0}}, {8, 16, 1}));
  scene.shapes.back().material = 1;
  for (const Precision precision : asked_tiers()) require_all(color(scene, precision), {2, 1, 1});
}

TEST_CASE("a mirror is black from behind unless it is two-sided, and shows emitters alone to direct") {
  require_pocl();
  const Plane away{{0, 0, 0}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}};
  const auto lit = [](const Plane& plane, bool twosided, const char* integrator, bool has_sky = true) {
    Scene scene = stage({plane, Plane{{0, 0, 9}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}}}, mirror({1, 1, 1}, twosided));
    scene.materials.push_back(diffuse({1, 1, 1}));
    scene.shapes[1].material = 1;
    scene.integrator.name = integrator;
    scene.lights = {light(PointLight{{0, 0, 2}, {1, 1, 1}})};
    if (has_sky) {
      scene.shapes.pop_back();
      scene.lights.push_back(light(ConstantLight{}));
    }
    return lit_pixels(color(scene));
  };
  const std::size_t all = stage_size * stage_size;
  CHECK(lit(floor_plane(), false, "whitted") == all);
  CHECK(lit(away, false, "whitted") == 0);
  CHECK(lit(away, true, "whitted") == all);
  for (const char* integrator : {"direct", "path"}) {
    CHECK(lit(floor_plane(), true, integrator) == all);
    CHECK(lit(away, false, integrator) == 0);
  }
  CHECK(lit(floor_plane(), true, "whitted", false) == all);
  CHECK(lit(floor_plane(), true, "path", false) == all);
  CHECK(lit(floor_plane(), true, "direct", false) == 0);
}

TEST_CASE("depth counts every mirror, and emitters are hidden from the camera only") {
  require_pocl();
  Scene scene = whitted({}, mirror({0.5, 0.5, 0.5}));
  scene.shapes = {glowing(slanted(), {1, 1, 1}), glowing(wall(), {2, 2, 2})};
  scene.materials.push_back(diffuse({1, 1, 1}));
  scene.shapes[1].material = 1;
  scene.lights = {light(PointLight{{40, 0, 0}, {300, 300, 300}})};  // Lights the wall; mirrors do not show it.
  const auto value = [&](int max_depth, bool hide) {
    scene.integrator.max_depth = max_depth;
    scene.integrator.hide_emitters = hide;
    scene.shapes[0].radiance.reset();  // Looked through, were it hidden.
    if (!hide) scene.shapes[0].radiance = Rgb{1, 1, 1};
    return double{color(scene).at(stage_size / 2, stage_size / 2, 0)};
  };
  CHECK(value(0, false) == 0);
  CHECK(value(1, false) == 1);
  CHECK(value(1, true) == 0);
  CHECK(value(2, false) == 2);
  CHECK(value(2, true) == 1);
  const double lamp = 0.5 * 300 / 100 / std::numbers::pi;
  for (const int depth : {3, 7, -1}) {
    CHECK(value(depth, false) == Approx(2 + lamp).epsilon(1e-3));
    CHECK(value(depth, true) == Approx(1 + lamp).epsilon(1e-3));
  }
}

TEST_CASE("between facing mirrors a path without a limit ends") {
  require_pocl();
  Scene scene = whitted({floor_plane(), Plane{{0, 0, 8}, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}}}, mirror({1, 1, 1}));
  scene.film.width = scene.film.height = 4;
  scene.lights = {light(ConstantLight{})};
  RenderSettings settings;
  settings.count_rays = true;
  const RenderResult endless = render("pocl", scene, settings);
  CHECK(lit_pixels(endless.color) == 0);
  CHECK(endless.stats.bounce_rays == 4 * 4 * 1024);
  scene.materials[0] = mirror({0, 0, 0});
  CHECK(render("pocl", scene, settings).stats.bounce_rays == 0);
}

TEST_CASE("without mirrors whitted is direct, bit for bit") {
  require_pocl();
  using Case = std::pair<const char*, Precision>;
  for (const auto& [name, precision] :
       {Case{"lecture/lit.xml", Precision::robust}, Case{"shapes/cube.xml", Precision::stable}}) {
    INFO(name << ", " << precision_name(precision));
    Scene scene = small_scene(scene_folder / name, 48, 32, 4);
    const RenderResult direct = render("pocl", scene, all_aovs(precision));
    scene.integrator.name = "whitted";
    CHECK(lit_pixels(direct.color) > 0);
    CHECK(same_bits(direct, render("pocl", scene, all_aovs(precision))));
  }
}

TEST_CASE("direct says that mirrors will show emitters alone") {
  Scene scene = stage({floor_plane()}, mirror({1, 1, 1}));
  scene.lights.push_back({"", ConstantLight{{1, 1, 1}}, {}});
  REQUIRE(limitations(scene).size() == 1);
  CHECK(limitations(scene)[0].message.find("whitted") != std::string::npos);
  scene.integrator.name = "whitted";
  CHECK(limitations(scene).empty());
}

}  // namespace
}  // namespace strahl::test
