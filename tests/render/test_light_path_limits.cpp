// SPDX-License-Identifier: MIT
// What paths from lights cannot do is refused with its remedy before anything is built.
#include <catch2/catch.hpp>

#include "render/stage.h"
#include "scene/model/build.h"

namespace strahl::test {
namespace {

Scene glass_and_point() { return small_scene(scene_folder / "lights/caustic.xml", 29, 23, 16); }

TEST_CASE("what light paths cannot have is refused") {
  require_pocl();
  const Device device = Device::open("pocl");
  const auto why_not = [&](const Scene& scene, const RenderSettings& settings = {}) -> std::string {
    try {
      Renderer(device, scene, settings);
    } catch (const std::exception& error) {
      return error.what();
    }
    return {};
  };
  Scene scene = glass_and_point();
  RenderSettings settings;
  settings.aovs = {Aov::depth};
  CHECK_THAT(why_not(scene, settings), Catch::Contains("--aov needs a camera ray"));
  settings = {};
  settings.light_choice = "tree";
  CHECK_THAT(why_not(scene, settings), Catch::Contains("--light-choice power"));
  scene.media.emplace_back();
  CHECK_THAT(why_not(scene), Catch::Contains("take integrator volpath"));
  scene = glass_and_point();
  scene.shapes.front().geometry = Plane{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}};
  CHECK(why_not(scene).empty());
  add(scene, ConstantLight{{1, 1, 1}});
  CHECK_THAT(why_not(scene), Catch::Contains("a large finite one"));
  scene = glass_and_point();
  scene.sampler.kind = SamplerKind::centre;
  CHECK_THAT(why_not(scene), Catch::Contains("another sampler"));
  scene = glass_and_point();
  settings = {};
  settings.disabled = {"PIXEL_FILTER"};
  CHECK_THAT(why_not(scene, settings), Catch::Contains("--disable PIXEL_FILTER"));
  scene.film.filter = {FilterKind::box, 1e-4, 0.5};
  CHECK_THAT(why_not(scene), Catch::Contains("below 1/1024"));
  scene.film.filter = {FilterKind::gaussian, 2, 1e-5};
  CHECK_THAT(why_not(scene), Catch::Contains("below 1/1024"));
  scene.film.filter = {FilterKind::box, 0.1, 0.5};
  CHECK(why_not(scene).empty());
  scene.film.width = 40'000;  // Where numbers in single precision are 1/256 of a pixel apart.
  CHECK_THAT(why_not(scene), Catch::Contains("below 1/4:"));
  settings = {};
  settings.precision = Precision::fp64;
  CHECK(why_not(scene, settings).empty());
  scene = glass_and_point();
  scene.integrator.name = "bdpt";
  scene.shapes.front().priority = 1;
  scene.shapes.front().material = add(scene, Dielectric{});
  CHECK_THAT(why_not(scene), Catch::Contains("by priority"));
}

}  // namespace
}  // namespace strahl::test
