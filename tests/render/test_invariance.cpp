// SPDX-License-Identifier: MIT
// What must not change a single bit of a picture or its AOVs: a second run, the work-group, lanes, passes, one
// sum a pixel, a crop window. The generic program and the device are test_generic's and test_devices'.
#include <catch2/catch.hpp>
#include <functional>

#include "render/pictures.h"

namespace strahl::test {
namespace {

const std::filesystem::path lit = scene_folder / "lecture/lit.xml";

/// 64 samples a pixel with direct lighting, the size no multiple of any work-group's.
Scene reference_scene() { return small_scene(lit, 61, 47, 64); }

TEST_CASE("twice in a row") {
  require_pocl();
  Renderer renderer(Device::open("pocl"), reference_scene(), all_aovs());
  const RenderResult first = renderer.render();
  CHECK(lit_pixels(first.color) > 61 * 47 / 2);
  CHECK(same_bits(first, renderer.render()));
  CHECK(same_bits(first, render("pocl", reference_scene(), all_aovs())));
  Scene other_seed = reference_scene();
  other_seed.sampler.seed = 1;
  CHECK_FALSE(same_bits(first, render("pocl", other_seed, all_aovs())));
}

void hold_splits(Precision precision, const std::vector<WorkGroup>& groups) {
  require_pocl();
  const RenderResult expected = render("pocl", reference_scene(), all_aovs(precision));
  const auto check = [&](const std::string& what, const RenderSettings& settings) {
    INFO(what << ", " << precision_name(precision));
    CHECK(same_bits(expected, render("pocl", reference_scene(), settings)));
  };
  for (const WorkGroup group : groups) {
    RenderSettings settings = all_aovs(precision);
    settings.work_group = group;
    check("work-group " + std::to_string(group.x) + "x" + std::to_string(group.y), settings);
  }
  for (const int lanes : {1, 8, 16}) {
    if (precision == Precision::fp64 && lanes == 16) continue;
    RenderSettings settings = all_aovs(precision);
    settings.lanes = lanes;
    check("lanes " + std::to_string(lanes), settings);
  }
  for (const int passes : {1, 7, 64}) {
    RenderSettings settings = all_aovs(precision);
    settings.passes = passes;
    check("passes " + std::to_string(passes), settings);
  }
}

TEST_CASE("work-groups, lanes and passes") { hold_splits(Precision::robust, {{1, 1}, {7, 3}}); }

TEST_CASE("more work-groups, and all in double", "[slow]") {
  hold_splits(Precision::robust, {{8, 8}, {64, 1}});
  hold_splits(Precision::fp64, {{1, 1}, {8, 8}, {64, 1}, {7, 3}});
}

TEST_CASE("one sum or four") {
  require_pocl();
  const RenderResult expected = render("pocl", reference_scene(), all_aovs());
  for (const int passes : {1, 7}) {
    RenderSettings settings = all_aovs();
    settings.estimate_error = false;
    settings.passes = passes;
    CHECK(same_bits(expected, render("pocl", reference_scene(), settings)));
  }
  RenderSettings one_sum;
  one_sum.estimate_error = false;
  CHECK_THROWS_AS(render("pocl", small_scene(lit, 1, 1, max_spp + 1), one_sum), SceneError);
}

TEST_CASE("paths, however they are split") {
  require_pocl();
  const Scene scene = small_scene(scene_folder / "cornell/cornell-box.xml", 31, 23, 8);
  const RenderResult expected = render("pocl", scene, all_aovs());
  const auto check = [&](const std::function<void(RenderSettings&)>& change) {
    RenderSettings settings = all_aovs();
    change(settings);
    CHECK(same_bits(expected, render("pocl", scene, settings)));
  };
  check([](RenderSettings& settings) { settings.work_group = {7, 3}; });
  check([](RenderSettings& settings) { settings.passes = 3; });
  check([](RenderSettings& settings) { settings.lanes = 8; });
}

TEST_CASE("one pixel, one long row") {
  require_pocl();
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(16384, 1)}) {
    const Scene scene = small_scene(lit, width, height, 4);
    const RenderResult expected = render("pocl", scene, all_aovs());
    CHECK(expected.color.width == width);
    CHECK(expected.color.height == height);
    CHECK(lit_pixels(expected.color) > 0);
    for (const WorkGroup group : {WorkGroup{1, 1}, WorkGroup{8, 8}}) {
      RenderSettings settings = all_aovs();
      settings.work_group = group;
      CHECK(same_bits(expected, render("pocl", scene, settings)));
    }
  }
}

TEST_CASE("a crop is a part of the whole picture") {
  require_pocl();
  Scene scene = small_scene(lit, 64, 48, 8);
  const RenderResult whole = render("pocl", scene, all_aovs());
  for (const Window window : {Window{0, 0, 64, 48}, Window{13, 7, 50, 48}, Window{63, 47, 64, 48}}) {
    scene.film.crop = window;
    const RenderResult part = render("pocl", scene, all_aovs());
    REQUIRE(part.color.width == window.width());
    REQUIRE(part.color.height == window.height());
    const auto cut = [&](const Image& image) {
      Image result = image;
      result.width = window.width();
      result.height = window.height();
      result.data.clear();
      for (int y = window.y0; y < window.y1; ++y) {
        const auto row = image.data.begin();
        result.data.insert(result.data.end(), row + static_cast<std::ptrdiff_t>(image.index(window.x0, y, 0)),
                           row + static_cast<std::ptrdiff_t>(image.index(window.x1, y, 0)));
      }
      return result;
    };
    CHECK(same_bits(cut(whole.color), part.color));
    CHECK(same_bits(cut(whole.aov), part.aov));
  }
}

}  // namespace
}  // namespace strahl::test
