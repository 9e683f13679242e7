// SPDX-License-Identifier: MIT
#include "render/rounding_pilot.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/renderer.h"
#include "stopwatch.h"

namespace strahl {
namespace {

constexpr std::size_t least_seeds = 2;  ///< The fewest that separate constant differences from those that average out.
constexpr std::size_t most_seeds = 4;
constexpr int samples = 4;      ///< Of each seed.
constexpr int least_side = 12;  ///< Pixels.
constexpr int most_side = 40;
constexpr std::uint64_t most_bytes = std::uint64_t{64} << 20;

/// A pilot's sample in both tiers, counted in samples of the run: there are few of each pixel, and few pixels.
constexpr double cost_of_a_sample = 15;

/// Seconds to assume for the build where the run itself has built no program: twice the slowest of the shipped scenes.
constexpr double longest_build = 30;

/// The same view with few pixels. A crop window shrinks with it.
Scene small(Scene scene, int side) {
  const Window window = scene.film.window();
  const double factor = std::min(1.0, static_cast<double>(side) / std::max(window.width(), window.height()));
  const auto scaled = [&](int pixels) { return static_cast<int>(std::lround(pixels * factor)); };
  if (scene.film.crop)
    scene.film.crop = Window{scaled(window.x0), scaled(window.y0), std::max(scaled(window.x1), scaled(window.x0) + 1),
                             std::max(scaled(window.y1), scaled(window.y0) + 1)};
  scene.film.width = std::max(scaled(scene.film.width), scene.film.crop ? scene.film.crop->x1 : 1);
  scene.film.height = std::max(scaled(scene.film.height), scene.film.crop ? scene.film.crop->y1 : 1);
  return scene;
}

/// None where the time is over before the picture is done.
std::optional<Image> picture(Renderer& renderer, std::size_t seed, const ProgressCallback& goes_on) {
  RenderGoal goal;
  goal.spp = samples;
  goal.seed = static_cast<std::uint32_t>(seed);
  RenderResult result = renderer.render(goes_on, goal);
  if (!result.complete) return std::nullopt;
  return std::move(result.color);
}

/// Sums over all values of the pictures' differences from their references.
class PilotDifferences {
 public:
  void add(const Image& rounded, const Image& reference) {
    sums_.resize(rounded.data.size(), 0.0);
    for (std::size_t i = 0; i < sums_.size(); ++i) {
      const double difference = static_cast<double>(rounded.data[i]) - static_cast<double>(reference.data[i]);
      sums_[i] += difference;
      squares_ += difference * difference;
    }
    ++seeds_;
  }
  [[nodiscard]] std::size_t seeds() const { return seeds_; }

  [[nodiscard]] double rmse(int spp) const {
    double square_of_sums = 0;
    for (const double sum : sums_) square_of_sums += sum * sum;
    const double n = static_cast<double>(seeds_);
    // Products of two seeds' differences keep only the part that all seeds share.
    const double lasting = std::max(0.0, (square_of_sums - squares_) / (n * (n - 1)));
    const double fleeting = std::max(0.0, squares_ / n - lasting);
    return std::sqrt((lasting + fleeting * samples / std::max(spp, 1)) / static_cast<double>(sums_.size()));
  }

 private:
  std::vector<double> sums_;
  double squares_ = 0;
  std::size_t seeds_ = 0;
};

}  // namespace

int rounding_pilot_side(const RunStats& run, bool is_built, std::optional<double> most_seconds) {
  if (!most_seconds) return most_side;
  if (run.camera_rays == 0) return 0;
  // The program in double precision builds no longer than the tier's (docs/decisions/0011-error.md). Loading takes the
  // same time for every program.
  const bool is_known = is_built || !run.program_from_cache;
  const double build = is_known ? run.seconds.program : std::max(run.seconds.program, longest_build);
  const double left = *most_seconds - build - 2 * (run.seconds.upload + run.seconds.bvh);
  const double pixel = static_cast<double>(least_seeds) * samples * cost_of_a_sample * run.seconds.kernel /
                       static_cast<double>(run.camera_rays);
  if (left < least_side * least_side * pixel) return 0;
  return pixel > 0 ? static_cast<int>(std::min<double>(most_side, std::sqrt(left / pixel))) : most_side;
}

RenderSettings in_double_precision(RenderSettings settings) {
  settings.precision = Precision::fp64;
  settings.lanes.reset();
  settings.bvh_width.reset();
  settings.work_group.reset();
  settings.generic = false;
  return settings;
}

std::optional<double> rounding_rmse(const Device& device, const Scene& scene, const RenderSettings& settings,
                                    const RunStats& run, std::optional<double> most_seconds,
                                    const std::function<bool()>& goes_on) {
  if (!device.info().fp64 || settings.precision == Precision::fp64 || run.scene_bytes > most_bytes) return std::nullopt;
  // To ask the cache takes a program's text, which is more than a short run may spend.
  if (rounding_pilot_side(run, true, most_seconds) == 0) return std::nullopt;
  const Stopwatch watch;
  RenderSettings tier = settings;
  tier.aovs.clear();
  tier.error_map = false;
  const RenderSettings exact = in_double_precision(tier);
  const int side =
      rounding_pilot_side(run, most_seconds && Renderer::is_program_cached(device, scene, exact), most_seconds);
  if (side == 0) return std::nullopt;
  const Scene pilot = small(scene, side);
  const auto is_time_left = [&] {
    return (!most_seconds || watch.seconds() < *most_seconds) && (!goes_on || goes_on());
  };
  const auto between_launches = [&](const Progress&) { return is_time_left(); };
  Renderer rounding(device, pilot, tier);
  if (!is_time_left()) return std::nullopt;
  Renderer reference(device, pilot, exact);
  PilotDifferences differences;
  for (std::size_t seed = 0; seed < most_seeds; ++seed) {
    const std::optional<Image> rounded = picture(rounding, seed, between_launches);
    const std::optional<Image> right = rounded ? picture(reference, seed, between_launches) : std::nullopt;
    if (!right) break;
    differences.add(*rounded, *right);
  }
  if (differences.seeds() < least_seeds) return std::nullopt;
  return differences.rmse(run.spp);
}

}  // namespace strahl
