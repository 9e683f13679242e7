// SPDX-License-Identifier: MIT
#include "render/rounding_pilot.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/renderer.h"

namespace strahl {
namespace {

constexpr int seeds = 4;
constexpr int samples = 4;     ///< Of each seed.
constexpr int most_side = 40;  ///< Pixels.
constexpr std::uint64_t most_bytes = std::uint64_t{64} << 20;

/// The same view with few pixels. A crop window shrinks with it.
Scene small(Scene scene) {
  const Window window = scene.film.window();
  const double factor = std::min(1.0, static_cast<double>(most_side) / std::max(window.width(), window.height()));
  const auto scaled = [&](int pixels) { return static_cast<int>(std::lround(pixels * factor)); };
  if (scene.film.crop)
    scene.film.crop = Window{scaled(window.x0), scaled(window.y0), std::max(scaled(window.x1), scaled(window.x0) + 1),
                             std::max(scaled(window.y1), scaled(window.y0) + 1)};
  scene.film.width = std::max(scaled(scene.film.width), scene.film.crop ? scene.film.crop->x1 : 1);
  scene.film.height = std::max(scaled(scene.film.height), scene.film.crop ? scene.film.crop->y1 : 1);
  return scene;
}

std::vector<Image> pictures(const Device& device, const Scene& scene, const RenderSettings& settings) {
  Renderer renderer(device, scene, settings);
  std::vector<Image> all;
  for (int seed = 0; seed < seeds; ++seed) {
    RenderGoal goal;
    goal.spp = samples;
    goal.seed = static_cast<std::uint32_t>(seed);
    all.push_back(renderer.render({}, goal).color);
  }
  return all;
}

}  // namespace

std::optional<double> rounding_rmse(const Device& device, const Scene& scene, const RenderSettings& settings, int spp,
                                    std::uint64_t scene_bytes) {
  if (!device.info().fp64 || settings.precision == Precision::fp64 || scene_bytes > most_bytes) return std::nullopt;
  const Scene pilot = small(scene);
  RenderSettings tier = settings;
  tier.aovs.clear();
  tier.error_map = false;
  RenderSettings exact = tier;
  exact.precision = Precision::fp64;
  exact.lanes = 1;  // Builds in a third of the time that wider programs take.
  exact.bvh_width.reset();
  exact.generic = false;
  const std::vector<Image> rounded = pictures(device, pilot, tier);
  const std::vector<Image> reference = pictures(device, pilot, exact);
  double squares = 0, square_of_sums = 0;
  const std::size_t values = rounded.front().data.size();
  for (std::size_t i = 0; i < values; ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < seeds; ++k) {
      const double difference = static_cast<double>(rounded[k].data[i]) - static_cast<double>(reference[k].data[i]);
      sum += difference;
      squares += difference * difference;
    }
    square_of_sums += sum * sum;
  }
  // Products of two seeds' differences have nothing in common but what is the same in all.
  const double lasting = std::max(0.0, (square_of_sums - squares) / (seeds * (seeds - 1.0)));
  const double fleeting = std::max(0.0, squares / seeds - lasting);
  return std::sqrt((lasting + fleeting * samples / std::max(spp, 1)) / static_cast<double>(values));
}

}  // namespace strahl
