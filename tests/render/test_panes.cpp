// SPDX-License-Identifier: MIT
// Thin glass under volpath: what goes straight through is no event, and lights are seen through it. Against the closed
// form of one surface, and in white surroundings, which show every weight that does not fit its chance.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/filled.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

constexpr double ior = 1.7;

Material pane(const Rgb& tint = {1, 1, 1}) {
  Material material;
  material.bsdf = ThinDielectric{Dielectric{ior, 1, Reflectance{{1, 1, 1}}, Reflectance{tint}}};
  return material;
}

Rectangle across(double z) { return {{-9, -9, z}, {18, 0, 0}, {0, 18, 0}}; }

/// A floor of reflectance 0.5 below a pane.
Scene floor_below(const Material& above) {
  Scene scene = stage({floor_plane(), across(1)}, diffuse({0.5, 0.5, 0.5}));
  scene.materials.push_back(above);
  scene.shapes.back().material = 1;
  scene.integrator.name = "volpath";
  return scene;
}

/// What a pane lets through, all reflections between its faces summed.
double through(double cosine) {
  const double sine = std::sqrt(1 - cosine * cosine) / ior, inside = std::sqrt(1 - sine * sine);
  const double s = (cosine - ior * inside) / (cosine + ior * inside),
               p = (ior * cosine - inside) / (ior * cosine + inside), once = (s * s + p * p) / 2;
  return (1 - once) / (1 + once);
}

TEST_CASE("a lamp behind a pane lights what is before it, and the pane is no depth") {
  require_pocl();
  const Rgb tint{1, 0.5, 0.25};
  Scene scene = floor_below(pane(tint));
  scene.integrator.max_depth = 2;
  for (const double slope : {0.0, 1.0, 5.0}) {
    INFO(slope);
    scene.lights = {light(DirectionalLight{normalized(Vec3{slope, 0, -1}), {1, 1, 1}})};
    const double cosine = 1 / std::hypot(slope, 1), lit = 0.5 / std::numbers::pi * cosine;
    const Rgb mean = mean_of(drawn(scene, 256));
    CHECK(mean.r == Approx(lit * through(cosine) * through(1)).epsilon(2e-3));
    CHECK(mean.g == Approx(lit * through(cosine) * through(1) / 4).epsilon(2e-3));
    CHECK(mean.b == Approx(lit * through(cosine) * through(1) / 16).epsilon(2e-3));
  }
  // To path it is an event, and a lamp behind it is not seen.
  scene.integrator.name = "path";
  scene.integrator.max_depth = 3;
  CHECK(mean_of(drawn(scene, 16)).r == 0);
}

TEST_CASE("what a pane does not let through it reflects") {
  require_pocl();
  Scene scene = floor_below(pane());
  scene.materials[0] = diffuse({0, 0, 0});
  scene.lights = {light(ConstantLight{{1, 1, 1}})};
  CHECK(mean_of(drawn(scene, 256)).g == Approx(1 - through(1)).epsilon(1e-2));
}

TEST_CASE("panes, in masks and blends as well, are not seen in white surroundings") {
  require_pocl();
  for (const int kind : {0, 1, 2}) {
    INFO(kind);
    Scene scene = floor_below(pane());
    scene.materials[0] = diffuse({1, 1, 1});
    scene.lights = {light(ConstantLight{{1, 1, 1}})};
    if (kind == 1) scene.materials[1].opacity = Reflectance{{0.4, 0.4, 0.4}};
    if (kind == 2) {
      scene.materials.push_back(diffuse({1, 1, 1}, true));
      Material blend;
      blend.bsdf = Blend{{{0.3, 0.3, 0.3}}, 1, 2};
      scene.materials.push_back(blend);
      scene.shapes[1].material = 3;
    }
    scene.integrator.max_depth = 1000;
    const Rgb mean = mean_of(drawn(scene, 64));
    CHECK(mean.r == Approx(1).margin(4e-3));
    CHECK(mean.b == Approx(1).margin(4e-3));
  }
}

TEST_CASE("as in Mitsuba far_clip ends at what a camera's ray passes") {
  require_pocl();
  const auto beyond = [](Scene scene) {
    scene.sampler.kind = SamplerKind::sobol;
    scene.sampler.sample_count = 16;
    return render("pocl", scene, generic_settings()).color;
  };
  Material mask = diffuse({0, 0, 0});
  mask.opacity = Reflectance{{0.25, 0.25, 0.25}};
  Material clear;
  clear.bsdf = ThinDielectric{Dielectric{1, 1, Reflectance{{1, 1, 1}}, Reflectance{{0.75, 0.75, 0.75}}}};
  for (const Material& passed : {mask, clear})
    for (const char* integrator : {"path", "volpath", "bdpt"}) {
      INFO(integrator);
      Scene scene = floor_below(passed);
      scene.integrator.name = integrator;
      scene.integrator.max_depth = 4;
      scene.lights = {light(ConstantLight{{1, 1, 1}})};
      scene.materials[0] = diffuse({0, 0, 0});
      scene.shapes[0].geometry = across(0);
      scene.camera.far_clip = length(scene.camera.world_from_camera.translation()) - 0.5;
      CHECK(mean_of(beyond(scene)).g == 0);
      scene.shapes.pop_back();
      CHECK(mean_of(beyond(scene)).g == 1);
    }
}

TEST_CASE("paths through panes are the same one by one and in lanes, and as in the program with everything") {
  require_pocl();
  Scene scene = filled(Sphere{{0, 0, 0}, 1}, medium({1, 2, 4}, {0.9, 0.6, 0.8}));
  scene.materials.push_back(pane({1, 0.8, 0.6}));
  scene.shapes.front().material = 1;
  add(scene, floor_plane(), add(scene, Diffuse{{{0.5, 0.4, 0.3}}}));
  add(scene, Rectangle{{-2, -2, 2}, {2, 0, 0}, {0, 4, 0}}, 1);
  check_in_lanes(scene, true);
}

}  // namespace
}  // namespace strahl::test
