// SPDX-License-Identifier: MIT
// Samples of a pixel that are followed in lanes give the picture, the AOVs and the counts of samples followed one by
// one, bit for bit: kinds with a body for packets and without, trees, instances, smooth meshes, drawn and taken lights,
// mirrors, glass, hidden emitters, more samples than a pool holds, and few, so that a work-item takes a span of pixels.
// Every effect: test_generic.cpp. With STRAHL_LANES=long all tiers and widths, by a program for each scene.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <string_view>

#include "render/pictures.h"

namespace strahl::test {
namespace {

constexpr int odd_samples = 21;

RenderResult followed(const Scene& scene, RenderSettings settings, bool in_lanes) {
  settings.paths_in_lanes = in_lanes;
  const RenderResult result = render("pocl", scene, settings);
  const int lanes = result.stats.lanes;
  REQUIRE(lanes > 1);
  REQUIRE(result.stats.path_lanes == (in_lanes ? lanes : 1));
  return result;
}

void require_same(const Scene& scene, const RenderSettings& settings) {
  const RenderResult one = followed(scene, settings, false), lanes = followed(scene, settings, true);
  CHECK(one.stats.seconds.kernel > 0);
  REQUIRE(one.color.data.size() > 0);
  CHECK(same_bits(one, lanes));
  CHECK(one.stats.shadow_rays == lanes.stats.shadow_rays);
  CHECK(one.stats.bounce_rays == lanes.stats.bounce_rays);
}

Scene of(const std::string& name) { return small_scene(scene_folder / name, 24, 20, odd_samples); }

RenderSettings plain(Precision precision = Precision::robust, int lanes = 16) {
  RenderSettings settings;
  settings.precision = precision;
  settings.lanes = lanes;
  return settings;
}

bool is_long() {
  const char* run = std::getenv("STRAHL_LANES");
  return run != nullptr && std::string_view(run) == "long";
}

TEST_CASE("a closed room in lanes, in both tiers that keep their bits everywhere") {
  require_pocl_and_rusticl();
  const Scene scene = of("cornell/cornell-box.xml");
  require_same(scene, plain());
  require_same(scene, plain(Precision::fp64, 8));
  if (!is_long()) return;
  require_same(scene, plain(Precision::robust, 8));
  require_same(scene, plain(Precision::stable));
}

TEST_CASE("what is reported of first samples, and counts of rays, in lanes") {
  require_pocl_and_rusticl();
  Scene scene = of("materials/conductor.xml");
  RenderSettings settings = all_aovs();
  settings.lanes = 16;
  settings.count_rays = true;
  require_same(scene, settings);
}

TEST_CASE("shapes that are asked ray by ray in a tree, and emitters that the camera looks through, in lanes") {
  require_pocl_and_rusticl();
  Scene scene = of("lights/disk.xml");
  scene.integrator.name = "path";
  scene.integrator.max_depth = 4;
  scene.integrator.hide_emitters = true;
  RenderSettings settings = plain(Precision::robust, 8);
  settings.acceleration = Acceleration::tree;
  require_same(scene, settings);
  if (!is_long()) return;
  settings.acceleration = Acceleration::automatic;
  scene.integrator.hide_emitters = false;
  require_same(scene, settings);
  settings.acceleration = Acceleration::tree;
  require_same(scene, settings);
  Scene rectangle = of("lights/rectangle.xml");
  rectangle.integrator = scene.integrator;
  rectangle.integrator.hide_emitters = true;
  require_same(rectangle, plain());
}

TEST_CASE("smooth meshes and instances in a tree, in lanes") {
  require_pocl_and_rusticl();
  require_same(of("mesh/torus-and-icosphere.xml"), plain());
  require_same(of("instances/mushrooms.xml"), plain(Precision::fp64, 8));
  if (is_long()) require_same(of("instances/mushrooms.xml"), plain(Precision::robust, 8));
}

TEST_CASE("glass in a tree, in lanes, and more samples than a pool holds") {
  require_pocl_and_rusticl();
  RenderSettings settings = plain(Precision::robust, 8);
  settings.acceleration = Acceleration::tree;
  const Scene scene = small_scene(scene_folder / "materials/dielectric.xml", 12, 10, 150);
  require_same(scene, settings);
  if (!is_long()) return;
  settings.precision = Precision::fp64;
  require_same(scene, settings);
}

TEST_CASE("blends, masks, bent normals and textures in lanes, by programs of their own") {
  if (!is_long()) return;
  require_pocl_and_rusticl();
  require_same(of("materials/blendbsdf.xml"), plain());
  require_same(of("materials/mask.xml"), plain(Precision::robust, 8));
  require_same(of("materials/normalmap.xml"), plain());
  require_same(of("materials/bumpmap.xml"), plain(Precision::robust, 8));
  require_same(of("accuracy/checkerboard.xml"), plain());
}

/// Spans that end before the row does, and rows of a part of the picture.
void require_same_in_spans(Scene scene, const RenderSettings& settings) {
  scene.film.width = 27;
  scene.film.crop = Window{3, 2, 26, 19};
  for (const int samples : {1, 3, 7}) {
    INFO(samples << " samples");
    scene.sampler.sample_count = samples;
    require_same(scene, settings);
  }
}

TEST_CASE("few samples in lanes: meshes, first samples that are reported with textures, branches") {
  require_pocl_and_rusticl();
  require_same_in_spans(of("mesh/torus-and-icosphere.xml"), plain());
  RenderSettings settings = all_aovs();
  settings.lanes = 8;
  require_same_in_spans(of("accuracy/checkerboard.xml"), settings);
  Scene branching = of("materials/dielectric.xml");
  branching.integrator.name = "whitted";
  require_same_in_spans(branching, plain(Precision::robust, 8));
}

TEST_CASE("few samples in lanes by any launches") {
  require_pocl_and_rusticl();
  const Scene scene = small_scene(scene_folder / "cornell/cornell-box.xml", 70, 9, 6);
  RenderSettings settings = plain();
  const RenderResult whole = followed(scene, settings, true);
  settings.passes = 4;
  settings.work_group = {4, 2};
  CHECK(same_bits(whole, followed(scene, settings, true)));
}

}  // namespace
}  // namespace strahl::test
