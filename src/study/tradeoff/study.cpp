// SPDX-License-Identifier: MIT
#include "study/tradeoff/study.h"

#include <algorithm>

#include "study/tradeoff/pareto.h"

namespace strahl {

std::vector<Metric> study_metrics() {
  std::vector<Metric> metrics = all_metrics();
  std::erase_if(metrics, [](Metric metric) {
    return metric == Metric::mse || metric == Metric::rmse || metric == Metric::hdrflip;
  });
  return metrics;
}

void conclude(TradeoffStudy& study) {
  std::vector<Cost> costs;
  for (const TradeoffPoint& point : study.points) costs.push_back({point.seconds.kernel, point.error.rmse()});
  const std::vector<bool> front = pareto_front(costs);
  for (std::size_t i = 0; i < front.size(); ++i) study.points[i].pareto = front[i];

  study.fits.clear();
  std::vector<TradeoffSetting> fitted;
  for (const TradeoffPoint& first : study.points) {
    const auto is_of_row = [&](const TradeoffSetting& other) { return other.is_same_but_for_samples(first.setting); };
    if (std::any_of(fitted.begin(), fitted.end(), is_of_row)) continue;
    fitted.push_back(first.setting);
    std::vector<std::pair<double, double>> by_seconds, by_samples;
    for (const TradeoffPoint& point : study.points) {
      if (!is_of_row(point.setting)) continue;
      by_seconds.emplace_back(point.seconds.kernel, point.error.rmse());
      by_samples.emplace_back(point.setting.spp, point.error.rmse());
    }
    if (const std::optional<PowerLaw> law = fit_power_law(by_seconds))
      study.fits.push_back({first.setting, *law, fit_power_law(by_samples)});
  }
}

}  // namespace strahl
