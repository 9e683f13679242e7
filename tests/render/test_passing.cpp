// SPDX-License-Identifier: MIT
// Surfaces that paths and shadow rays pass: ignored interfaces of glass, holes of masks, and parts of blends.
#include <catch2/catch.hpp>

#include "render/filled.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

Sphere ball(const Vec3& center, double radius) { return {center, radius, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}; }

Material glass(double ior) {
  Material material;
  material.bsdf = Dielectric{ior, 1, Reflectance{{1, 1, 1}}, Reflectance{{1, 1, 1}}};
  return material;
}

void add_shape(Scene& scene, const Geometry& geometry, const Material& material, std::optional<int> priority = {}) {
  scene.materials.push_back(material);
  Shape shape;
  shape.geometry = geometry;
  shape.material = static_cast<int>(scene.materials.size()) - 1;
  shape.priority = priority;
  scene.shapes.push_back(shape);
}

/// By the scene's own program, whose paths are not those of the one with every effect, or by that one.
double mean_in(Scene scene, int samples, const char* integrator, bool generic = false) {
  scene.integrator.name = integrator;
  scene.sampler.kind = SamplerKind::independent;
  scene.sampler.sample_count = samples;
  RenderSettings settings;
  settings.precision = Precision::robust;
  settings.generic = generic;
  return mean_of(render("pocl", scene, settings).color).r;
}

/// A floor within a ball of index 1 and rank 2, lit by a lamp beside the picture that a ball of rank 1 is around.
Scene lamp_in_ignored_glass(bool is_there) {
  Scene scene = stage({Rectangle{{-2, -2, -1}, {4, 0, 0}, {0, 4, 0}}}, diffuse({0.5, 0.5, 0.5}));
  scene.integrator.max_depth = 8;
  add_shape(scene, ball({0, 0, 0}, 3.5), glass(1), 2);
  add_shape(scene, ball({0, 2.8, 0}, 0.3), diffuse({0, 0, 0}));
  scene.shapes.back().radiance = Rgb{10, 10, 10};
  if (is_there) add_shape(scene, ball({0, 2.8, 0}, 0.5), glass(1.5), 1);
  return scene;
}

TEST_CASE("a lamp in ignored glass lights as if the glass were not there") {
  require_pocl();
  CHECK(mean_in(lamp_in_ignored_glass(true), 1024, "path") ==
        Approx(mean_in(lamp_in_ignored_glass(false), 256, "path")).epsilon(0.02));
}

/// The camera's ray enters the ball of rank 2, is scattered by the floor and meets the ignored glass at its last depth.
TEST_CASE("at the last depth, too, ignored glass is passed", "[slow]") {
  require_pocl();
  for (const char* integrator : {"path", "volpath"}) {
    INFO(integrator);
    const auto mean = [&](bool is_there, int samples) {
      Scene scene = lamp_in_ignored_glass(is_there);
      scene.integrator.max_depth = 3;
      return mean_in(scene, samples, integrator);
    };
    const double expected = mean(false, 256);
    REQUIRE(expected > 0.001);
    CHECK(mean(true, 1024) == Approx(expected).epsilon(0.02));
  }
  // volpath sees lamps through panes and masks, too, and weighs them against what its rays find.
  Scene without = lamp_in_ignored_glass(false), around = lamp_in_ignored_glass(true);
  without.integrator.max_depth = around.integrator.max_depth = 3;
  around.media.emplace_back().sigma_t = Rgb{1e-6, 1e-6, 1e-6};
  around.shapes.back().media = MediumBoundary{0, -1};
  Material& ignored = around.materials.back();
  const double expected = mean_in(without, 256, "volpath");
  ignored.opacity = Reflectance{{0.5, 0.5, 0.5}};
  CHECK(mean_in(around, 1024, "volpath") == Approx(expected).epsilon(0.02));
  ignored.opacity = {};
  ignored.bsdf = ThinDielectric{Dielectric{1.5, 1, Reflectance{{1, 1, 1}}, Reflectance{{1, 1, 1}}}};
  CHECK(mean_in(around, 1024, "volpath") == Approx(expected).epsilon(0.02));
  for (const bool is_there : {false, true}) {
    Scene scene = stage({ball({0, 0, 0}, 3)}, glass(1));
    scene.shapes.front().priority = 2;
    add_shape(scene, Rectangle{{-3, -3, 0}, {6, 0, 0}, {0, 6, 0}}, diffuse({0, 0, 0}));
    scene.shapes.back().radiance = Rgb{3, 3, 3};
    if (is_there) add_shape(scene, ball({0, 0, 0}, 2.9), glass(1.5), 1);
    CHECK(mean_in(scene, 4, "direct") == Approx(3));
  }
}

/// `front` before a ball of glass, and a wall behind, half of which shines.
Scene before_a_ball(const Geometry& geometry, const Material& front, bool ranked) {
  Scene scene = stage({Rectangle{{-9, -9, -3}, {18, 0, 0}, {0, 18, 0}}}, diffuse({0.2, 0.2, 0.2}));
  scene.integrator.max_depth = 12;
  const auto rank = [&](int priority) { return ranked ? std::optional(priority) : std::nullopt; };
  add_shape(scene, Rectangle{{0, -9, -2.9}, {9, 0, 0}, {0, 18, 0}}, diffuse({0, 0, 0}));
  scene.shapes.back().radiance = Rgb{1, 1, 1};
  add_shape(scene, geometry, front, rank(2));
  add_shape(scene, ball({0, 0, -1}, 1), glass(1.5), rank(1));
  return scene;
}

TEST_CASE("priorities of shapes that do not overlap change nothing") {
  require_pocl();
  Material holes = glass(1.5), pane;
  holes.opacity = Reflectance{{0.5, 0.5, 0.5}};
  pane.bsdf = ThinDielectric{Dielectric{1.5, 1, Reflectance{{1, 1, 1}}, Reflectance{{1, 1, 1}}}};
  const Rectangle sheet{{-2, -2, 2}, {4, 0, 0}, {0, 4, 0}};
  const auto mean = [](const Geometry& geometry, const Material& front, bool ranked) {
    return mean_in(before_a_ball(geometry, front, ranked), 16, "path", !ranked);
  };
  CHECK(mean(ball({0, 0, 2}, 0.9), holes, true) == Approx(mean(ball({0, 0, 2}, 0.9), holes, false)).epsilon(1e-5));
  CHECK(mean(sheet, pane, true) == Approx(mean(sheet, pane, false)).epsilon(1e-5));
}

TEST_CASE("shadow rays draw which part of a blend they meet") {
  require_pocl();
  for (const double weight : {0.3, 0.7}) {
    INFO(weight);
    Scene scene = stage({floor_plane()}, diffuse({0.5, 0.5, 0.5}));
    scene.materials.push_back(diffuse({0, 0, 0}));
    Material null;
    null.opacity = Reflectance{{0, 0, 0}};
    scene.materials.push_back(null);
    Material blend;
    blend.bsdf = Blend{{{weight, weight, weight}}, 1, 2};
    add_shape(scene, Rectangle{{-9, -9, 1}, {18, 0, 0}, {0, 18, 0}}, blend);
    scene.lights = {light(DirectionalLight{{0, 0, -1}, {1, 1, 1}})};
    // Once for the camera, once for the light.
    CHECK(mean_in(scene, 1024, "volpath") == Approx(weight * weight * 0.5 / std::numbers::pi).epsilon(0.01));
  }
}

TEST_CASE("each side of a twosided material has its own opacity") {
  require_pocl();
  for (const bool is_open : {false, true}) {
    INFO(is_open);
    // From behind.
    Scene scene = stage({Rectangle{{-9, -9, 0}, {0, 18, 0}, {18, 0, 0}}}, diffuse({0, 0, 0}));
    Material side = diffuse({0, 0, 0}), front = diffuse({0, 0, 0}, true);
    (is_open ? side : front).opacity = Reflectance{{0, 0, 0}};
    front.back = 0;
    scene.materials = {side, front};
    scene.shapes.front().material = 1;
    scene.lights = {light(ConstantLight{{1, 1, 1}})};
    CHECK(mean_in(scene, 4, "path") == (is_open ? 1 : 0));
  }
}

// Were one number to decide at both walls of the ball, half of the rays would go through both.
TEST_CASE("blends one behind the other on a ray: each draws by a number of its own") {
  require_pocl();
  Scene scene = stage({});
  Material null = diffuse({0, 0, 0}), half;
  null.opacity = Reflectance{{0, 0, 0}};
  scene.materials = {diffuse({0, 0, 0}, true), null};
  half.bsdf = Blend{{{0.5, 0.5, 0.5}}, 0, 1};
  add_shape(scene, ball({0, 0, 0}, 3.5), half);
  scene.lights = {light(ConstantLight{{1, 1, 1}})};
  scene.film.width = scene.film.height = 16;
  for (const char* integrator : {"path", "volpath"}) {
    INFO(integrator);
    scene.integrator.name = integrator;
    CHECK(mean_of(drawn(scene, 1024)).r == Approx(0.25).margin(0.005));
  }
}

// The mask takes the path's first number of the stream, and no mirror takes one.
TEST_CASE("blends behind a mask that a path has passed: each draws by a number of its own") {
  require_pocl();
  Scene scene = stage({Rectangle{{-9, -9, 3}, {18, 0, 0}, {0, 18, 0}}}, diffuse({0, 0, 0}));
  scene.materials[0].opacity = Reflectance{{0, 0, 0}};
  Material mirror, black = diffuse({0, 0, 0}, true), half;
  mirror.bsdf = Conductor{};
  mirror.twosided = true;
  scene.materials.insert(scene.materials.end(), {mirror, black});
  half.bsdf = Blend{{{0.5, 0.5, 0.5}}, 1, 2};
  // Down onto a mirror at 45 degrees, along -x, and up off another one.
  add_shape(scene, Rectangle{{-3, -9, -3}, {0, 18, 0}, {6, 0, 6}}, half);
  add_shape(scene, Rectangle{{-5, -9, -4}, {0, 18, 0}, {-8, 0, 8}}, half);
  scene.lights = {light(ConstantLight{{1, 1, 1}})};
  scene.integrator.name = "volpath";
  scene.film.width = scene.film.height = 8;
  CHECK(mean_of(drawn(scene, 1024)).r == Approx(0.25).margin(0.01));
}

}  // namespace
}  // namespace strahl::test
