// SPDX-License-Identifier: MIT
// The stated 95 % interval against the truth: over many seeds it holds a picture's true RMSE as often as it says, for
// both samplers, and without being so wide that it says nothing. The truth of each picture is the mean of all others.
// STRAHL_COVERAGE=long: more scenes, 200 seeds, 16 to 1,024 samples; STRAHL_COVERAGE_SCENE: only files with that text.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "render/median.h"
#include "render/pictures.h"

namespace strahl::test {
namespace {

struct Case {
  const char* file;
  const char* integrator;
  int width, height;
  std::vector<int> samples;
};

const std::vector<Case> short_cases{{"lights/rectangle.xml", "direct", 48, 36, {16, 50}},
                                    {"mesh/torus-and-icosphere.xml", "ao", 48, 36, {16}},
                                    {"cornell/cornell-box.xml", "path", 64, 64, {16}}};
const std::vector<int> powers{16, 64, 256, 1024};
const std::vector<Case> long_cases{
    {"lights/rectangle.xml", "direct", 32, 24, powers},      {"mesh/torus-and-icosphere.xml", "ao", 32, 24, powers},
    {"cornell/cornell-box.xml", "path", 32, 32, powers},     {"lights/constant.xml", "path", 32, 24, powers},
    {"textures/checkerboard.xml", "direct", 32, 24, powers}, {"shapes/triangle.xml", "direct", 32, 24, powers}};

bool is_long() { return std::getenv("STRAHL_COVERAGE") != nullptr; }

bool is_wanted(const Case& what) {
  const char* text = std::getenv("STRAHL_COVERAGE_SCENE");
  return text == nullptr || std::string(what.file).find(text) != std::string::npos;
}

struct Tally {
  int inside = 0;
  double half_width = 0;  ///< Relative, the median over the seeds.
  double told = 0;        ///< RMSE, the root of the mean square over the seeds, against the true one.
};

Scene scene_of(const Case& what, SamplerKind sampler) {
  Scene scene = small_scene(scene_folder / what.file, what.width, what.height, what.samples[0]);
  scene.integrator.name = what.integrator;
  scene.sampler.kind = sampler;
  return scene;
}

/// The mean of the others has noise of its own, as large a part of the squared difference as one picture is of all.
Tally tally(Renderer& renderer, int samples, int seeds) {
  std::vector<RenderResult> pictures;
  std::vector<double> sum;
  for (int seed = 0; seed < seeds; ++seed) {
    RenderGoal goal;
    goal.spp = samples;
    goal.seed = static_cast<std::uint32_t>(1000 + seed);
    pictures.push_back(renderer.render({}, goal));
    const std::vector<float>& values = pictures.back().color.data;
    sum.resize(values.size(), 0.0);
    for (std::size_t i = 0; i < values.size(); ++i) sum[i] += values[i];
  }
  Tally result;
  std::vector<double> half_widths;
  double told = 0, truly = 0;
  for (const RenderResult& picture : pictures) {
    double squared = 0;
    for (std::size_t i = 0; i < sum.size(); ++i) {
      const double value = picture.color.data[i];
      squared += std::pow(value - (sum[i] - value) / (seeds - 1), 2);
    }
    const double mse = squared / static_cast<double>(sum.size()) * (seeds - 1) / seeds, rmse = std::sqrt(mse);
    REQUIRE(picture.error);
    const ErrorEstimate& error = *picture.error;
    if (error.rmse_low <= rmse && rmse <= error.rmse_high) ++result.inside;
    half_widths.push_back((error.rmse_high - error.rmse_low) / (2 * error.rmse));
    told += error.rmse * error.rmse;
    truly += mse;
  }
  result.half_width = median(half_widths);
  result.told = std::sqrt(told / truly);
  return result;
}

TEST_CASE("the interval holds the true error as often as it says") {
  require_pocl_and_rusticl();
  const int seeds = is_long() ? 200 : 40;
  int inside = 0, all = 0;
  for (const Case& what : is_long() ? long_cases : short_cases) {
    if (!is_wanted(what)) continue;
    for (const SamplerKind sampler : {SamplerKind::independent, SamplerKind::sobol}) {
      Renderer renderer(Device::open("pocl"), scene_of(what, sampler));
      for (const int samples : what.samples) {
        const Tally found = tally(renderer, samples, seeds);
        const std::string name = fmt::format("{}, {}, {}, {} samples", what.file, what.integrator,
                                             sampler == SamplerKind::sobol ? "sobol" : "independent", samples);
        fmt::print("{}: {} of {} inside, ±{:.1f} %, told : true {:.2f}\n", name, found.inside, seeds,
                   100 * found.half_width, found.told);
        std::fflush(stdout);
        INFO(name);
        CHECK(found.inside >= 0.9 * seeds);
        CHECK(found.half_width <= (is_long() ? 0.8 : 0.35));
        inside += found.inside;
        all += seeds;
      }
    }
  }
  fmt::print("{} of {} inside\n", inside, all);
  CHECK(inside >= 0.93 * all);
}

}  // namespace
}  // namespace strahl::test
