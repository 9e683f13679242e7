// SPDX-License-Identifier: MIT
// The same bits on every device that is there, in picture and AOVs: direct lighting with 64 samples a pixel, a mesh;
// test_every_scene has the rest. PoCL and rusticl may not be missing; a line per picture says which ran. Mesa's
// llvmpipe takes tens of milliseconds for a launch and emulates fma, hence the sizes.
#include <algorithm>
#include <catch2/catch.hpp>
#include <iostream>

#include "errors.h"
#include "render/stage.h"
#include "scene/model/build.h"
#include "trust/tier_choice.h"

namespace strahl::test {
namespace {

void check_everywhere(const std::string& name, Precision single, int width, int height, int spp) {
  require_pocl_and_rusticl();
  const Scene scene = small_scene(scene_folder / name, width, height, spp);
  const auto has_double = [](const std::string& device) { return Device::open(device).info().fp64; };
  const std::vector<std::string> devices = present_devices();
  for (const Precision precision : {single, Precision::fp64}) {
    // PoCL's double is held against another device's.
    if (precision == Precision::fp64 && std::count_if(devices.begin(), devices.end(), has_double) < 2) continue;
    const RenderResult expected = render("pocl", scene, all_aovs(precision));
    CHECK(lit_pixels(expected.color) > 0);
    std::string ran, skipped;
    for (const std::string& device : devices) {
      INFO(name << ", " << precision_name(precision) << ", " << device);
      if (precision == Precision::fp64 && !has_double(device)) {
        skipped += " " + device;
        continue;
      }
      ran += " " + device;
      CHECK(same_bits(expected, render(device, scene, all_aovs(precision))));
    }
    std::cout << name << ", " << precision_name(precision) << ": ran on" << ran
              << (skipped.empty() ? "" : "; without double:" + skipped) << std::endl;
  }
}

// In stable, for rusticl takes most of a minute to compile a robust picture's program: test_every_scene has those, and
// robust_test_devices the tier's intersections.
TEST_CASE("spheres and planes, 64 samples") { check_everywhere("lecture/lit.xml", Precision::stable, 24, 18, 64); }

TEST_CASE("paths between spheres, one of them a lamp, under a sky") {
  require_pocl_and_rusticl();
  Scene scene = stage({Sphere{{0, 0, 0}, 1}}, diffuse({0.8, 0.7, 0.6}));
  add(scene, emitting(Sphere{{0.5, 1, 2}, 0.5}, {4, 3, 2}));
  add(scene, ConstantLight{{0.2, 0.3, 0.4}});
  scene.film.width = scene.film.height = 12;
  scene.integrator.name = "path";
  scene.integrator.max_depth = 9;
  scene.sampler.sample_count = 8;
  const RenderSettings settings = all_aovs(Precision::stable);
  const RenderResult expected = render("pocl", scene, settings);
  CHECK(lit_pixels(expected.color) > 140);  // Two just touch the lamp.
  for (const std::string& device : present_devices()) {
    INFO(device);
    CHECK(same_bits(expected, render(device, scene, settings)));
  }
}

TEST_CASE("a mesh") { check_everywhere("shapes/mesh-obj.xml", Precision::stable, 16, 12, 2); }

TEST_CASE("long paths in a box of mirrors") {
  require_pocl_and_rusticl();
  Scene scene = small_scene(scene_folder / "accuracy/mirror-box.xml", 8, 6, 1);
  const Device device = Device::open("llvmpipe");
  RenderSettings settings;
  settings.precision = Precision::stable;
  settings.loop_turns = choose_tier(device, Precision::stable).tier.loop_turns;
  REQUIRE(settings.loop_turns);
  // As many samples as one launch could not take.
  scene.integrator.max_depth = 50;
  scene.sampler.sample_count = 200;
  CHECK(same_bits(render("pocl", scene, settings), Renderer(device, scene, settings).render()));
}

}  // namespace
}  // namespace strahl::test
