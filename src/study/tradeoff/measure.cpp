// SPDX-License-Identifier: MIT
#include "study/tradeoff/measure.h"

#include <algorithm>
#include <cmath>

#include "render/median.h"
#include "stopwatch.h"

namespace strahl {
std::optional<MeasuredPoint> measure_point(Renderer& renderer, const TradeoffSetting& setting, int seeds,
                                           const TradeoffReference& reference, const ProgressCallback& progress) {
  std::vector<Image> pictures;
  std::vector<double> kernel, wall;
  TradeoffPoint point;
  point.setting = setting;
  point.seeds = seeds;
  for (int seed = 1; seed <= seeds; ++seed) {
    RenderGoal goal;
    goal.spp = setting.spp;
    goal.seed = reference_seed + static_cast<std::uint32_t>(seed);
    const Stopwatch watch;
    RenderResult result = renderer.render(progress, goal);
    wall.push_back(watch.seconds());
    if (!result.complete) return std::nullopt;
    kernel.push_back(result.stats.seconds.kernel);
    pictures.push_back(std::move(result.color));
    const RunStats& stats = result.stats;
    point.program = stats.program;
    point.program_from_cache = stats.program_from_cache;
    point.seconds = {stats.seconds.program, stats.seconds.bvh, stats.seconds.upload, 0, 0};
    point.unusual += stats.unusual;
  }
  point.seconds.kernel = median(kernel);
  point.seconds.wall = point.seconds.program + point.seconds.bvh + point.seconds.upload + median(wall);
  point.error = error_parts(pictures, reference.picture, reference.rmse.value_or(0) * reference.rmse.value_or(0));
  for (const Metric metric : study_metrics()) {
    double sum = metric_obstacle(reference.picture, metric).empty() ? 0 : std::nan("");
    for (const Image& picture : pictures)
      if (!std::isnan(sum)) sum += compare_images(picture, reference.picture, metric);
    point.metrics.emplace_back(metric_name(metric), sum / seeds);
  }
  return MeasuredPoint{std::move(point), std::move(pictures.front())};
}

}  // namespace strahl
