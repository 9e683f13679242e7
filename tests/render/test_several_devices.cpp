// SPDX-License-Identifier: MIT
// A picture that several devices share has every bit of one device's: picture, AOVs, told error; with each goal, in
// bands, gone on with, as a part.
#include <catch2/catch.hpp>

#include "errors.h"
#include "render/film_state.h"
#include "render/pictures.h"

namespace strahl::test {
namespace {

Scene shared_scene(int spp = 32) { return small_scene(scene_folder / "cornell/cornell-box.xml", 29, 23, spp); }

RenderSettings shared_settings(Precision precision = Precision::robust) {
  RenderSettings settings = all_aovs(precision);
  settings.error_map = true;
  return settings;
}

/// Two queues of PoCL, and where it is asked for llvmpipe too.
Renderer shared(const Scene& scene, const RenderSettings& settings, bool with_llvmpipe = false) {
  Renderer renderer(Device::open("pocl", {settings.precision == Precision::fp64}), scene, settings);
  renderer.share_with(Device::open("pocl", {settings.precision == Precision::fp64}));
  if (with_llvmpipe) renderer.share_with(Device::open("llvmpipe"));
  return renderer;
}

void check_same(const RenderResult& a, const RenderResult& b) {
  CHECK(same_bits(a, b));
  CHECK(same_bits(a.standard_error, b.standard_error));
  REQUIRE(a.error.has_value() == b.error.has_value());
  if (!a.error) return;
  CHECK(a.error->rmse == b.error->rmse);
  CHECK(a.error->rmse_low == b.error->rmse_low);
  CHECK(a.error->rmse_high == b.error->rmse_high);
}

TEST_CASE("two of one kind, and three") {
  require_pocl_and_rusticl();
  Renderer one(Device::open("pocl"), shared_scene(), shared_settings());
  const RenderResult expected = one.render();
  for (const bool with_llvmpipe : {false, true}) {
    Renderer several = shared(shared_scene(), shared_settings(), with_llvmpipe);
    // The second time their speeds are known. Which one is given how many rows is for the processor to decide; sooner
    // or later each of one kind has its part.
    std::array<std::uint64_t, 2> parts{};
    for (int i = 0; i < 2 || (i < 50 && parts[0] * parts[1] == 0); ++i) {
      const RenderResult result = several.render();
      check_same(expected, result);
      CHECK(result.ending == Ending::samples);
      std::uint64_t samples = 0;
      for (const DeviceShare& share : result.stats.shares) samples += share.samples;
      CHECK(result.stats.shares.size() == (with_llvmpipe ? 3 : 2));
      CHECK(samples == 29 * 23 * 32);
      CHECK(result.stats.camera_rays == samples);
      for (std::size_t part = 0; part < parts.size(); ++part) parts[part] += result.stats.shares[part].samples;
    }
    CHECK(parts[0] > 0);
    CHECK(parts[1] > 0);
  }
  CHECK(expected.stats.shares.empty());
}

TEST_CASE("in double, and one sum a pixel", "[slow]") {
  require_pocl_and_rusticl();
  for (RenderSettings settings : {shared_settings(Precision::fp64), shared_settings()}) {
    settings.estimate_error = settings.precision == Precision::fp64;
    settings.error_map = settings.estimate_error;
    Renderer one(Device::open("pocl", {true}), shared_scene(6), settings);
    check_same(one.render(), shared(shared_scene(6), settings).render());
  }
}

TEST_CASE("an error as the goal") {
  require_pocl_and_rusticl();
  RenderGoal goal;
  goal.max_error = 0.06;
  Renderer one(Device::open("pocl"), shared_scene(), shared_settings());
  const RenderResult expected = one.render({}, goal);
  Renderer several = shared(shared_scene(), shared_settings());
  const RenderResult result = several.render({}, goal);
  CHECK(result.ending == Ending::error);
  CHECK(result.stats.spp == expected.stats.spp);
  check_same(expected, result);
}

TEST_CASE("a deadline leaves a film of whole samples") {
  require_pocl_and_rusticl();
  Renderer several = shared(shared_scene(), shared_settings());
  RenderGoal goal;
  goal.deadline = later(Clock::now(), 0.4);
  FilmKeeper keeper;
  std::optional<FilmState> last;
  keeper.keep_last = [&](FilmState state) { last = std::move(state); };
  const RenderResult result = several.render({}, goal, &keeper);
  CHECK(result.ending == Ending::deadline);
  CHECK(result.stats.least_spp > 1);
  // The film is what its numbers say: filled up to the most samples it is that of one device.
  goal.deadline = later(Clock::now(), 1e6);
  goal.spp = result.stats.most_spp + 1;
  FilmKeeper resuming;
  resuming.begin_with = &*last;
  Renderer one(Device::open("pocl"), shared_scene(), shared_settings());
  check_same(one.render({}, goal), one.render({}, goal, &resuming));
}

TEST_CASE("stopped at any launch, gone on with, by one or several") {
  require_pocl_and_rusticl();
  RenderSettings settings = shared_settings();
  settings.passes = 5;
  Renderer one(Device::open("pocl"), shared_scene(), settings);
  const RenderResult expected = one.render();
  std::vector<FilmState> states;
  FilmKeeper keeper;
  keeper.keep_last = [&](FilmState state) { states.push_back(std::move(state)); };
  for (const int launches : {1, 3, 7, 20}) {
    Renderer several = shared(shared_scene(), settings);
    int left = launches;
    const RenderResult stopped = several.render([&](const Progress&) { return --left > 0; }, {}, &keeper);
    CHECK(stopped.ending == Ending::stopped);
  }
  Renderer several = shared(shared_scene(), settings);
  for (const FilmState& state : states) {
    FilmKeeper resuming;
    resuming.begin_with = &state;
    check_same(expected, one.render({}, {}, &resuming));
    check_same(expected, several.render({}, {}, &resuming));
  }
}

TEST_CASE("in bands") {
  require_pocl_and_rusticl();
  Renderer one(Device::open("pocl"), shared_scene(), shared_settings());
  const auto film_bytes = [](const RunStats& stats) { return stats.device_bytes - stats.scene_bytes; };
  const std::uint64_t row = film_bytes(one.stats()) / 23;
  const DeviceNeeds two_rows{
      false, one.stats().scene_bytes + (2 * row + row / 2) * 4 / 3};  // A quarter for the ring of samples.
  Renderer several(Device::open("pocl", two_rows), shared_scene(), shared_settings());
  REQUIRE(film_bytes(several.stats()) == 2 * row);
  several.share_with(Device::open("pocl", two_rows));
  const RenderResult expected = one.render();
  // Once their speeds are known, the faster of two gets a quarter of the 23 rows at first: three bands.
  for (int i = 0; i < 2; ++i) check_same(expected, several.render());
}

TEST_CASE("rays that are counted") {
  require_pocl_and_rusticl();
  RenderSettings settings = shared_settings();
  settings.count_rays = true;
  settings.paths_in_lanes = false;      // What paths visit that go together depends on which do.
  settings.disabled = without_sharing;  // Rows on either side of where parts meet are followed by both devices.
  Renderer one(Device::open("pocl"), shared_scene(), settings);
  const RenderResult expected = one.render();
  Renderer several = shared(shared_scene(), settings);
  for (int i = 0; i < 2; ++i) {
    const RenderResult result = several.render();
    check_same(expected, result);
    CHECK(result.stats.camera_rays == expected.stats.camera_rays);
    CHECK(result.stats.shadow_rays == expected.stats.shadow_rays);
    CHECK(result.stats.bounce_rays == expected.stats.bounce_rays);
    CHECK(result.stats.nodes_visited == expected.stats.nodes_visited);
    CHECK(result.stats.primitives_tested == expected.stats.primitives_tested);
  }
  CHECK(expected.stats.shadow_rays.value_or(0) > 0);
  CHECK(expected.stats.bounce_rays.value_or(0) > 0);
  CHECK(expected.stats.primitives_tested.value_or(0) > 0);
}

TEST_CASE("a part of the samples") {
  require_pocl_and_rusticl();
  RenderGoal goal;
  goal.samples = {5, 17};
  Renderer one(Device::open("pocl"), shared_scene(), shared_settings());
  check_same(one.render({}, goal), shared(shared_scene(), shared_settings()).render({}, goal));
}

TEST_CASE("paths from lights, which end in any row") {
  require_pocl_and_rusticl();
  for (const char* integrator : {"ptracer", "bdpt"}) {
    INFO(integrator);
    Scene scene = shared_scene();
    scene.integrator.name = integrator;
    RenderSettings settings;
    settings.error_map = true;
    Renderer one(Device::open("pocl"), scene, settings);
    const RenderResult expected = one.render();
    Renderer several = shared(scene, settings);
    std::array<std::uint64_t, 2> parts{};
    for (int i = 0; i < 2 || (i < 50 && parts[0] * parts[1] == 0); ++i) {
      const RenderResult result = several.render();
      check_same(expected, result);
      for (std::size_t part = 0; part < parts.size(); ++part) parts[part] += result.stats.shares[part].samples;
    }
    CHECK(parts[0] * parts[1] > 0);
    // Stopped, and gone on with by one.
    std::optional<FilmState> last;
    FilmKeeper keeper;
    keeper.keep_last = [&](FilmState state) { last = std::move(state); };
    int left = 3;
    static_cast<void>(several.render([&](const Progress&) { return --left > 0; }, {}, &keeper));
    FilmKeeper resuming;
    resuming.begin_with = &*last;
    check_same(expected, one.render({}, {}, &resuming));
    check_same(expected, several.render({}, {}, &resuming));
  }
}

TEST_CASE("what several devices do not do") {
  require_pocl_and_rusticl();
  Renderer stable(Device::open("pocl"), shared_scene(), shared_settings(Precision::stable));
  CHECK_THROWS_AS(stable.share_with(Device::open("pocl")), UsageError);
  Renderer several = shared(shared_scene(), shared_settings());
  RenderGoal goal;
  goal.rows = Rows{0, 5};
  CHECK_THROWS_AS(several.render({}, goal), UsageError);
}

}  // namespace
}  // namespace strahl::test
