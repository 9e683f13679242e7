// SPDX-License-Identifier: MIT
// LaunchPlan hands out every pixel sample exactly once whatever the launches take, and keeps them short.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "render/launch_plan.h"
#include "render/pictures.h"

namespace strahl::test {
namespace {

using Seconds = std::function<double(const Launch&)>;

double samples_of(const Launch& launch) { return static_cast<double>(launch.columns) * launch.rows * launch.samples; }

/// Runs the plan and returns its launches, having checked that they cover all samples of all pixels once.
std::vector<Launch> run(LaunchPlan plan, int width, int height, int samples, const Seconds& seconds) {
  const auto w = static_cast<std::size_t>(width), h = static_cast<std::size_t>(height);
  std::vector<int> done(w * h, 0);
  std::vector<Launch> launches;
  bool in_order = true, inside = true;
  while (!plan.finished() && inside) {
    const Launch launch = plan.next();
    launches.push_back(launch);
    inside = launch.columns > 0 && launch.rows > 0 && launch.samples > 0 && launch.column_first >= 0 &&
             launch.row_first >= 0 && launch.column_first + launch.columns <= width &&
             launch.row_first + launch.rows <= height;
    REQUIRE(inside);
    for (int y = launch.row_first; y < launch.row_first + launch.rows; ++y)
      for (int x = launch.column_first; x < launch.column_first + launch.columns; ++x) {
        int& pixel = done[static_cast<std::size_t>(y) * w + static_cast<std::size_t>(x)];
        in_order = in_order && pixel == launch.sample_first;
        pixel += launch.samples;
      }
    plan.measured(seconds(launch));
  }
  CHECK(in_order);
  CHECK(std::all_of(done.begin(), done.end(), [&](int count) { return count == samples; }));
  return launches;
}

TEST_CASE("every sample of every pixel once, in order") {
  std::mt19937 random(1);
  const std::vector<Seconds> patterns = {
      [](const Launch&) { return 0.0; },
      [](const Launch&) { return 10.0; },
      [](const Launch& launch) { return 1e-6 * samples_of(launch); },
      [](const Launch& launch) { return 1e-3 * samples_of(launch); },
      [&](const Launch&) { return std::ldexp(1.0, -static_cast<int>(random() % 20)); },
  };
  for (const auto& [width, height] : {std::pair(1, 1), {1, 257}, {16384, 1}, {7, 5}, {64, 48}, {61, 47}})
    for (const int samples : {1, 2, 7, 64})
      for (const std::optional<int> passes :
           {std::optional<int>(), std::optional(1), std::optional(7), std::optional(1000)})
        for (std::size_t i = 0; i < patterns.size(); ++i) {
          INFO(width << " x " << height << ", " << samples << " samples, passes " << passes.value_or(0) << ", pattern "
                     << i);
          const std::vector<Launch> launches =
              run(LaunchPlan(width, height, samples, passes), width, height, samples, patterns[i]);
          if (!passes) continue;
          int ranges = 0;
          for (const Launch& launch : launches) ranges += launch.column_first == 0 && launch.row_first == 0 ? 1 : 0;
          CHECK(ranges == std::min(*passes, samples));
        }
}

TEST_CASE("launches stay short at any speed and few where the device is fast") {
  for (const double rate : {1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3}) {
    const int width = 200, height = 100, samples = rate > 1e-5 ? 1 : 64;
    INFO(rate << " s a sample");
    double longest = 0, total = 0;
    const std::vector<Launch> launches =
        run(LaunchPlan(width, height, samples, {}), width, height, samples, [&](const Launch& launch) {
          const double seconds = rate * samples_of(launch);
          longest = std::max(longest, seconds);
          total += seconds;
          return seconds;
        });
    CHECK(longest < 0.25);
    CHECK(static_cast<double>(launches.size()) < 3 * total / LaunchPlan::target_seconds + 100);
  }
}

TEST_CASE("a part of the picture four times as costly does not make a long launch") {
  const double rate = 1e-5;
  double longest = 0;
  run(LaunchPlan(200, 100, 16, {}), 200, 100, 16, [&](const Launch& launch) {
    const double seconds = rate * samples_of(launch) * (launch.row_first + launch.rows > 50 ? 4 : 1);
    longest = std::max(longest, seconds);
    return seconds;
  });
  CHECK(longest > LaunchPlan::target_seconds);
  CHECK(longest < 0.25);
}

TEST_CASE("what a launch costs by itself is not work: launches do not shrink under it") {
  const double overhead = 0.08, rate = 1e-6;
  const std::vector<Launch> launches = run(LaunchPlan(200, 100, 16, {}, {overhead}), 200, 100, 16,
                                           [&](const Launch& launch) { return overhead + rate * samples_of(launch); });
  CHECK(launches.size() < 20);
}

TEST_CASE("a device that takes pixels together gets them together, however long its paths are") {
  const int at_once = 1000;
  const Seconds seconds = [&](const Launch& launch) {
    const double items = static_cast<double>(launch.columns) * launch.rows;
    return 0.2 * launch.samples * std::max(1.0, items / at_once);
  };
  for (const auto& [width, height, launches] : {std::tuple(30, 20, 4), {100, 50, 4 * 6}})
    CHECK(run(LaunchPlan(width, height, 4, {}, {0, 1, at_once}), width, height, 4, seconds).size() <=
          static_cast<std::size_t>(launches));
  for (const auto& [passes, launches] : {std::pair(1, 6), {2, 2 * 6}})
    CHECK(run(LaunchPlan(100, 50, 1024, passes, {0, 1, at_once}), 100, 50, 1024, seconds).size() <=
          static_cast<std::size_t>(launches));
}

TEST_CASE("the next band begins at the measured rate") {
  LaunchPlan first(100, 100, 1, {});
  CHECK(samples_of(first.next()) == 64);
  for (int i = 0; i < 3; ++i) {
    first.measured(1e-6);
    (void)first.next();
  }
  first.measured(1e-6);
  LaunchPlan second(100, 100, 1, {});
  second.learn_from(first);
  CHECK(samples_of(second.next()) > 1000);
}

TEST_CASE("a renderer's second picture begins at the first one's rate") {
  require_pocl();
  Renderer renderer(Device::open("pocl"), small_scene(scene_folder / "cornell/cornell-box.xml", 64, 64, 16));
  const RenderResult first = renderer.render(), second = renderer.render();
  CHECK(second.stats.kernel_runs.size() < first.stats.kernel_runs.size());
  CHECK(second.color.data == first.color.data);
}

// Counting rays has every sample rendered.
TEST_CASE("samples that draw nothing are rendered once and counted all") {
  require_pocl();
  RenderSettings counting;
  counting.count_rays = true;
  for (const int spp : {1, 6, 8}) {
    INFO(spp << " samples");
    Scene scene = small_scene(scene_folder / "lecture/first-light.xml", 64, 48, spp);
    scene.sampler.kind = SamplerKind::centre;
    const RenderResult once = render("pocl", scene, {}), each = render("pocl", scene, counting);
    CHECK(lit_pixels(once.color) > 1000);
    CHECK(same_bits(once.color, each.color));
    CHECK(once.stats.camera_rays == 64U * 48U * static_cast<unsigned>(spp));
    REQUIRE(once.error.has_value() == each.error.has_value());
    if (once.error) CHECK(once.error->rmse == each.error->rmse);
  }
}

// Not a test of time: what a real render's launches take is only shown.
TEST_CASE("a real render reports its launches") {
  require_pocl();
  const Scene scene = small_scene(scene_folder / "cornell/cornell-box.xml", 256, 256, 8);
  const RunStats stats = render("pocl", scene, {}).stats;
  CHECK(stats.kernel_runs.size() > 1);
  CHECK(stats.longest_launch() == *std::max_element(stats.kernel_runs.begin(), stats.kernel_runs.end()));
  CHECK(stats.camera_rays == 256 * 256 * 8);
  WARN(stats.kernel_runs.size() << " launches, the longest of " << stats.longest_launch() << " s");
}

TEST_CASE("rows that are better whole are not split, however long they take") {
  const std::vector<Launch> launches = run(LaunchPlan(50, 7, 64, {}, {0, 64, 1, true}), 50, 7, 64,
                                           [](const Launch& launch) { return 1e-3 * samples_of(launch); });
  for (const Launch& launch : launches) CHECK(launch.columns == 50);
  CHECK(launches.size() == 7);
}

}  // namespace
}  // namespace strahl::test
