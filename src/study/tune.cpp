// SPDX-License-Identifier: MIT
#include "study/tune.h"

#include <algorithm>
#include <cmath>

namespace strahl {
namespace {

std::vector<int> widths_for(const Device& device, Precision precision) {
  if (device.info().native_vector_width < 8) return {2, 4};
  return precision == Precision::fp64 ? std::vector{4, 8} : std::vector{4, 8, 16};
}

}  // namespace

std::vector<TunedTier> tune(const Device& device, const Scene& scene, int side, const BenchProgress& progress) {
  const std::vector<Precision> tiers = tiers_of(device);
  const int total = static_cast<int>(tiers.size() * all_ray_kinds.size()) * bench_rounds;
  int done = 0;
  std::vector<TunedTier> tuned;
  for (const Precision tier : tiers) {
    const std::vector<int> widths = widths_for(device, tier);
    std::vector<Intersector> intersectors;
    for (const int width : widths) {
      RenderSettings settings;
      settings.precision = tier;
      settings.bvh_width = width;
      settings.acceleration = Acceleration::tree;
      intersectors.emplace_back(device, scene, settings);
    }
    std::vector<double> logarithms(widths.size(), 0.0);
    for (const RaySet& set : bench_rays(intersectors.back(), scene, side)) {
      const std::vector<double> seconds = median_seconds(intersectors, set, [&] {
        if (progress) progress(done, total);
        ++done;
      });
      for (std::size_t i = 0; i < widths.size(); ++i)
        logarithms[i] += std::log(static_cast<double>(set.rays.size()) / seconds[i]);
    }
    TunedTier& one = tuned.emplace_back();
    one.precision = tier;
    for (std::size_t i = 0; i < widths.size(); ++i)
      one.mrays[widths[i]] = std::exp(logarithms[i] / static_cast<double>(all_ray_kinds.size())) / 1e6;
    one.best = std::max_element(one.mrays.begin(), one.mrays.end(), [](const auto& a, const auto& b) {
                 return a.second < b.second;
               })->first;
  }
  return tuned;
}

}  // namespace strahl
