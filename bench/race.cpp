// SPDX-License-Identifier: MIT
#include "bench/race.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace strahl::bench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool differ(double a, double b) {
  if (a == infinity || b == infinity) return a != b;
  return !(std::abs(a - b) <= 0x1p-10 * std::max(a, b));  // NaN differs.
}

}  // namespace

double speed_ratio(const Entry& a, const Entry& b) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < std::min(a.seconds.size(), b.seconds.size()); ++i)
    ratios.push_back(b.seconds[i] / a.seconds[i]);
  return median(ratios);
}

std::vector<std::vector<double>> take_turns(const std::vector<std::function<double()>>& runs, int rounds) {
  std::vector<std::vector<double>> seconds(runs.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < runs.size(); ++i) seconds[i].push_back(runs[i]());
  return seconds;
}

Race race(std::span<const std::unique_ptr<Contender>> contenders, const RaySet& set, int rounds) {
  Race race{{}, 0, ray_kind_name(set.kind), set.rays.size(), {}};
  std::vector<double> expected;
  std::vector<std::function<double()>> runs;
  for (const std::unique_ptr<Contender>& contender : contenders) {
    Entry& entry = race.entries.emplace_back(Entry{contender->program(), contender->variant(), {}, 0, 0, 0});
    contender->load(set);
    static_cast<void>(contender->trace());
    entry.build_seconds = contender->build_seconds();
    const std::vector<double> answers = contender->distances();
    if (expected.empty()) expected = answers;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      entry.hits += answers[i] < infinity;
      entry.differing += differ(answers[i], expected[i]);
    }
    if (entry.differing * 50 > answers.size())
      throw Error(fmt::format("{} {}: {} of {} {} rays are answered otherwise than by {} {}; their time means nothing",
                              entry.program, entry.variant, entry.differing, answers.size(), race.kind,
                              race.entries.front().program, race.entries.front().variant));
    runs.emplace_back([&contender] { return contender->trace(); });
  }
  const std::vector<std::vector<double>> seconds = take_turns(runs, rounds);
  for (std::size_t i = 0; i < seconds.size(); ++i) race.entries[i].seconds = seconds[i];
  return race;
}

}  // namespace strahl::bench
