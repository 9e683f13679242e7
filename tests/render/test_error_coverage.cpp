// SPDX-License-Identifier: MIT
// The stated 95 % interval against the truth: over many seeds it holds a picture's true RMSE as often as it says, for
// both samplers, and without being so wide that it says nothing. STRAHL_COVERAGE_SEEDS: more seeds than 40.
// STRAHL_COVERAGE_SPP: samples a pixel of a reference that takes the place of the other seeds' mean.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <vector>

#include "render/pictures.h"

namespace strahl::test {
namespace {

struct Case {
  const char* file;
  const char* integrator;
  int width, height, spp;
};

const Case cases[] = {{"lights/rectangle.xml", "direct", 48, 36, 16},
                      {"mesh/torus-and-icosphere.xml", "ao", 48, 36, 16},
                      {"cornell/cornell-box.xml", "path", 80, 80, 16}};

struct Tally {
  int inside = 0;
  double half_width = 0;  ///< Relative, the mean over the seeds.
};

int number_from(const char* variable, int otherwise) {
  const char* text = std::getenv(variable);
  return text != nullptr ? std::atoi(text) : otherwise;
}

Scene scene_of(const Case& what, SamplerKind sampler) {
  Scene scene = small_scene(scene_folder / what.file, what.width, what.height, what.spp);
  scene.integrator.name = what.integrator;
  scene.sampler.kind = sampler;
  return scene;
}

/// Empty: none is asked for.
std::vector<float> reference_of(const Case& what) {
  const int spp = number_from("STRAHL_COVERAGE_SPP", 0);
  if (spp == 0) return {};
  RenderGoal goal;
  goal.spp = spp;
  goal.seed = 7;
  return Renderer(Device::open("pocl"), scene_of(what, SamplerKind::sobol)).render({}, goal).color.data;
}

/// The truth of each picture is the reference or else the mean of all others, whose own noise is known: it is as large
/// a part of the squared difference as one picture is of the number of all.
Tally tally(const Case& what, SamplerKind sampler, int seeds, const std::vector<float>& reference) {
  Renderer renderer(Device::open("pocl"), scene_of(what, sampler));
  std::vector<RenderResult> pictures;
  std::vector<double> sum;
  for (int seed = 0; seed < seeds; ++seed) {
    RenderGoal goal;
    goal.seed = static_cast<std::uint32_t>(1000 + seed);
    pictures.push_back(renderer.render({}, goal));
    const std::vector<float>& values = pictures.back().color.data;
    sum.resize(values.size(), 0.0);
    for (std::size_t i = 0; i < values.size(); ++i) sum[i] += values[i];
  }
  const double noise = reference.empty() ? static_cast<double>(seeds - 1) / seeds : 1;
  Tally result;
  for (const RenderResult& picture : pictures) {
    double squared = 0;
    for (std::size_t i = 0; i < sum.size(); ++i) {
      const double value = picture.color.data[i];
      const double truth = reference.empty() ? (sum[i] - value) / (seeds - 1) : static_cast<double>(reference[i]);
      const double difference = value - truth;
      squared += difference * difference;
    }
    const double rmse = std::sqrt(squared / static_cast<double>(sum.size()) * noise);
    REQUIRE(picture.error);
    if (picture.error->rmse_low <= rmse && rmse <= picture.error->rmse_high) ++result.inside;
    result.half_width += (picture.error->rmse_high - picture.error->rmse_low) / (2 * picture.error->rmse) / seeds;
  }
  return result;
}

TEST_CASE("the interval holds the true error as often as it says") {
  require_pocl_and_rusticl();
  const int seeds = number_from("STRAHL_COVERAGE_SEEDS", 40);
  for (const Case& what : cases) {
    const std::vector<float> reference = reference_of(what);
    for (const SamplerKind sampler : {SamplerKind::independent, SamplerKind::sobol}) {
      const Tally found = tally(what, sampler, seeds, reference);
      const std::string name =
          std::string(what.integrator) + (sampler == SamplerKind::sobol ? ", sobol" : ", independent");
      std::cout << name << ": " << found.inside << " of " << seeds << " inside, ±" << 100 * found.half_width << " %"
                << std::endl;
      INFO(name);
      CHECK(found.inside >= 0.9 * seeds);
      if (seeds > 100) CHECK(found.inside <= 0.99 * seeds);
      CHECK(found.half_width <= 0.25);
    }
  }
}

}  // namespace
}  // namespace strahl::test
