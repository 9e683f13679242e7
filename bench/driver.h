// SPDX-License-Identifier: MIT
// Times of a workload in several tiers, taken in turns so that what slows the machine slows all of them alike.
#pragma once

#include "bench/workload.h"
#include "opencl/device.h"

namespace strahl::bench {

struct Timing {
  std::string workload;
  std::size_t shapes = 0;
  Precision precision = Precision::robust;
  int lanes = 1;
  double nanoseconds = 0;      ///< A ray; median of the rounds.
  double least = 0, most = 0;  ///< Of the rounds.
  double ratio = 1;            ///< To the first tier: median of the rounds' ratios.
  double hits = 0;             ///< Share of the rays that hit.
};

/// Warms each tier up, then `rounds` times each in turn. Throws Error where a tier hits or misses other rays than the
/// oracle says: more than one in a thousand, which ordinary conditioning does not explain.
[[nodiscard]] std::vector<Timing> time_tiers(const Device& device, const Workload& workload,
                                             const std::vector<Precision>& tiers, int rounds);

}  // namespace strahl::bench
