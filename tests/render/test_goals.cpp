// SPDX-License-Identifier: MIT
// Renders that end at a deadline or an error are the same pictures that the same samples make, no pixel is two samples
// ahead of another, and the error that they stop at is true.
#include <catch2/catch.hpp>
#include <cmath>

#include "render/pictures.h"
#include "render/pilot.h"

namespace strahl::test {
namespace {

Scene cornell() { return small_scene(scene_folder / "cornell/cornell-box.xml", 96, 96, 16); }

RenderGoal within(double seconds) {
  RenderGoal goal;
  goal.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  return goal;
}

TEST_CASE("a time that is later is so for all times and all seconds") {
  using Limits = std::numeric_limits<double>;
  const Clock::time_point now = Clock::now();
  CHECK(later(now, 1.5) - now == std::chrono::milliseconds(1500));
  CHECK(later(now, -1.5) - now == -std::chrono::milliseconds(1500));
  CHECK(later(now, Limits::quiet_NaN()) == now);
  for (const double seconds : {-Limits::infinity(), -1e300, -1e9, -0.1, 0.0, 0.1, 1e9, 1e300, Limits::infinity()}) {
    INFO(seconds);
    const auto away = [&](Clock::time_point time) {
      return std::chrono::duration<double>(later(time, seconds) - now).count();
    };
    CHECK(away(Clock::time_point::min()) < -1e9);
    CHECK(away(Clock::time_point::max()) > 1e9);
  }
}

TEST_CASE("a deadline that was long ago leaves no time, and one that never comes ends nothing") {
  require_pocl();
  Renderer renderer(Device::open("pocl"), cornell());
  RenderGoal goal;
  goal.deadline = Clock::time_point::min();
  CHECK(renderer.render({}, goal).ending == Ending::deadline);
  goal.deadline = Clock::time_point::max();
  goal.spp = 2;
  const RenderResult all = renderer.render({}, goal);
  CHECK(all.ending == Ending::samples);
  CHECK(all.stats.least_spp == 2);
}

TEST_CASE("a deadline ends it, pixels at most one sample apart") {
  require_pocl();
  Renderer renderer(Device::open("pocl"), cornell());
  const RenderResult result = renderer.render({}, within(0.4));
  CHECK(result.ending == Ending::deadline);
  CHECK(result.complete);
  CHECK(result.stats.least_spp >= 1);
  CHECK(result.stats.most_spp - result.stats.least_spp <= 1);
  // Later frames know what the end takes; one that has no time at all is black, and says so.
  const RenderResult nothing = renderer.render({}, within(-1));
  CHECK(nothing.stats.least_spp == 0);
  CHECK(lit_pixels(nothing.color) == 0);
  CHECK_FALSE(nothing.error);
}

TEST_CASE("a deadline is kept after pictures of few rows, and of no samples") {
  require_pocl();
  Scene scene = cornell();
  scene.integrator.name = "emission";
  scene.sampler.kind = SamplerKind::independent;
  scene.film.width = scene.film.height = 1024;
  RenderSettings settings;
  settings.error_map = true;
  Renderer renderer(Device::open("pocl"), scene, settings);
  // The end takes hundreds of milliseconds by itself, some more beside other work.
  const auto seconds_late = [&] {
    const RenderGoal goal = within(3);
    const RenderResult result = renderer.render({}, goal);
    const double late = std::chrono::duration<double>(Clock::now() - *goal.deadline).count();
    const double end = result.stats.seconds.readback + result.stats.seconds.error;
    UNSCOPED_INFO("late by " << late << " s, and the end took " << end << " s");
    return late - 0.5 * end;
  };
  // Other work on the machine may hold one up, not all of three.
  const auto is_in_time = [&](const RenderGoal& before) {
    for (int i = 0; i < 3; ++i) {
      static_cast<void>(renderer.render({}, before));
      if (seconds_late() < 0) return true;
    }
    return false;
  };
  RenderGoal row;
  row.rows = Rows{500, 1};
  row.spp = 8;
  CHECK(is_in_time(row));
  CHECK(is_in_time(within(-1)));
}

TEST_CASE("what a deadline ended after n samples is the picture of n samples") {
  require_pocl();
  Renderer renderer(Device::open("pocl"), cornell());
  RenderGoal goal = within(20);
  goal.spp = 6;
  const RenderResult ended = renderer.render({}, goal);
  CHECK(ended.ending == Ending::samples);
  RenderGoal plain;
  plain.spp = 6;
  const RenderResult expected = renderer.render({}, plain);
  CHECK(same_bits(expected.color, ended.color));
  plain.seed = 5;
  CHECK_FALSE(same_bits(expected.color, renderer.render({}, plain).color));
  plain.seed.reset();
  CHECK(same_bits(expected.color, renderer.render({}, plain).color));
}

TEST_CASE("an error is reached, and is the true one") {
  require_pocl();
  Scene scene = small_scene(scene_folder / "mesh/torus-and-icosphere.xml", 64, 48, 16);
  scene.integrator.name = "ao";
  for (const SamplerKind sampler : {SamplerKind::independent, SamplerKind::sobol}) {
    scene.sampler.kind = sampler;
    Renderer renderer(Device::open("pocl"), scene);
    RenderGoal much;
    much.spp = 1024;
    much.seed = 99;
    const RenderResult truth = renderer.render({}, much);
    REQUIRE(truth.error);
    RenderGoal goal;
    goal.max_error = 0.02;
    const RenderResult result = renderer.render({}, goal);
    REQUIRE(result.error);
    CHECK(result.ending == Ending::error);
    CHECK(result.error->rmse <= 0.02);
    double squared = 0;
    for (std::size_t i = 0; i < result.color.data.size(); ++i)
      squared += std::pow(static_cast<double>(result.color.data[i]) - static_cast<double>(truth.color.data[i]), 2);
    const double of_truth = truth.error->rmse * truth.error->rmse;
    CHECK(std::sqrt(squared / static_cast<double>(result.color.data.size()) - of_truth) <= 1.1 * 0.02);
    // Not by doing far more than was asked for.
    CHECK(result.error->rmse > 0.6 * 0.02);
  }
}

TEST_CASE("without its sums no error is told, and the same samples make the same picture") {
  require_pocl();
  RenderSettings settings;
  Scene scene = cornell();
  scene.sampler.kind = SamplerKind::independent;
  settings.estimate_error = false;
  const RenderResult plain = render("pocl", scene, settings);
  CHECK_FALSE(plain.error);
  settings.estimate_error = true;
  settings.error_map = true;
  const RenderResult told = render("pocl", scene, settings);
  REQUIRE(told.error);
  CHECK(same_bits(plain.color, told.color));
  double squared = 0;
  for (const float value : told.standard_error.data) squared += static_cast<double>(value) * static_cast<double>(value);
  CHECK(std::sqrt(squared / static_cast<double>(told.standard_error.data.size())) == Approx(told.error->rmse));
}

TEST_CASE("without its sums sobol's samples are one sequence, of less noise") {
  require_pocl();
  const auto variance = [](bool estimate_error) {
    RenderSettings settings;
    settings.estimate_error = estimate_error;
    Renderer renderer(Device::open("pocl"), cornell(), settings);
    RenderGoal one, other;
    one.spp = other.spp = 64;
    one.seed = 1;
    other.seed = 2;
    const Image a = renderer.render({}, one).color, b = renderer.render({}, other).color;
    double sum = 0;
    for (std::size_t i = 0; i < a.data.size(); ++i)
      sum += std::pow(static_cast<double>(a.data[i]) - static_cast<double>(b.data[i]), 2);
    return sum;
  };
  const double one = variance(false), two = variance(true);
  INFO(one << " against " << two);
  CHECK(one < 0.85 * two);
}

TEST_CASE("fewer samples than sums tell nothing") {
  require_pocl();
  RenderGoal goal;
  goal.spp = 3;
  CHECK_FALSE(Renderer(Device::open("pocl"), cornell()).render({}, goal).error);
}

TEST_CASE("a pilot that has time for the whole picture only by what its strips tell looks at that") {
  require_pocl();
  Renderer renderer(Device::open("pocl"), cornell());
  const Pilot pilot = run_pilot(renderer, 1024, [](const Pilot& so_far) { return so_far.passes.empty() ? 0.0 : 3.0; });
  REQUIRE_FALSE(pilot.passes.empty());
  CHECK(pilot.passes.front().samples >= 8);
  CHECK(pilot.share == 1);
  CHECK(pilot.mean > 0);
}

TEST_CASE("a pilot traces no numeric_error") {
  require_pocl();
  RenderSettings settings;
  settings.aovs = {Aov::depth, Aov::numeric_error};
  Renderer renderer(Device::open("pocl"), cornell(), settings);
  RenderGoal goal;
  goal.spp = 1;
  CHECK(renderer.render({}, goal).aov.channels == std::vector<std::string>{"depth.Z", "numeric_error.ULP"});
  goal.is_pilot = true;
  CHECK(renderer.render({}, goal).aov.channels == std::vector<std::string>{"depth.Z"});
}

}  // namespace
}  // namespace strahl::test
