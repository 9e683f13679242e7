// SPDX-License-Identifier: MIT
// Programs that answer the same rays in turns, so that what slows the machine slows all of them alike; and only those
// whose answers agree.
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "bench/contender.h"
#include "render/median.h"

namespace strahl::bench {

/// One program's part in a race.
struct Entry {
  std::string program, variant;
  std::vector<double> seconds;  ///< A round each.
  double build_seconds = 0;
  std::size_t hits = 0;
  std::size_t differing = 0;  ///< Rays with another answer than the first entry's.
};

struct Race {
  std::string scene;
  std::size_t primitives = 0;
  std::string kind;  ///< Of the rays.
  std::size_t rays = 0;
  std::vector<Entry> entries;
};

/// seconds[i][round]: calls each in turn, `rounds` times.
[[nodiscard]] std::vector<std::vector<double>> take_turns(const std::vector<std::function<double()>>& runs, int rounds);

/// Every contender answers once before the clock runs. Throws Error where more than one ray in fifty has another answer
/// than the first contender's: hit or miss, or t off by more than a thousandth. That is room for the textbook's
/// spheres, which lose one ray in two hundred to spheres of a thousandth of their distance; the report counts them.
[[nodiscard]] Race race(std::span<const std::unique_ptr<Contender>> contenders, const RaySet& set, int rounds);

/// How many times as fast as `b` `a` is: the median of the rounds' ratios.
[[nodiscard]] double speed_ratio(const Entry& a, const Entry& b);

}  // namespace strahl::bench
