// SPDX-License-Identifier: MIT
#include "bench/driver.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/race.h"

namespace strahl::bench {
namespace {

void require_right(const Workload& workload, Precision precision, const std::vector<Hit>& hits) {
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) wrong += (hits[i].shape >= 0) != workload.hits[i];
  if (wrong * 1000 > hits.size())
    throw Error(fmt::format("{}, {}: {} of {} rays hit or miss against the oracle; their time means nothing",
                            workload.name, precision_name(precision), wrong, hits.size()));
}

}  // namespace

std::vector<Timing> time_tiers(const Device& device, const Workload& workload, const std::vector<Precision>& tiers,
                               int rounds) {
  std::vector<Intersector> intersectors;
  for (const Precision precision : tiers) {
    RenderSettings settings;
    settings.precision = precision;
    intersectors.emplace_back(device, workload.scene, settings);
    require_right(workload, precision, intersectors.back().trace(workload.rays));
  }
  std::vector<std::function<double()>> runs;
  for (Intersector& intersector : intersectors)
    runs.emplace_back([&intersector, &workload] {
      static_cast<void>(intersector.trace(workload.rays));
      return intersector.stats().seconds.kernel;
    });
  const std::vector<std::vector<double>> seconds = take_turns(runs, rounds);
  const auto rays = static_cast<double>(workload.rays.size());
  std::vector<Timing> timings;
  for (std::size_t i = 0; i < tiers.size(); ++i) {
    std::vector<double> ratios;
    for (std::size_t round = 0; round < seconds[i].size(); ++round)
      ratios.push_back(seconds[i][round] / seconds[0][round]);
    const auto [least, most] = std::minmax_element(seconds[i].begin(), seconds[i].end());
    timings.push_back({workload.name, workload.scene.shapes.size(), tiers[i], intersectors[i].stats().lanes,
                       median(seconds[i]) / rays * 1e9, *least / rays * 1e9, *most / rays * 1e9, median(ratios),
                       static_cast<double>(std::count(workload.hits.begin(), workload.hits.end(), true)) / rays});
  }
  return timings;
}

}  // namespace strahl::bench
