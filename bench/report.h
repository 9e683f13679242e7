// SPDX-License-Identifier: MIT
// Timings for people and for programs.
#pragma once

#include <string>

#include "bench/driver.h"

namespace strahl::bench {

/// What all timings of a run share.
struct Run {
  std::string device;
  std::size_t rays = 0;
  int rounds = 0;
};

/// A row a workload: nanoseconds a ray and, after the first tier, the ratio to it.
[[nodiscard]] std::string markdown(const Run& run, const std::vector<Timing>& timings);

/// bench/README.md states the members.
[[nodiscard]] std::string json(const Run& run, const std::vector<Timing>& timings);

}  // namespace strahl::bench
