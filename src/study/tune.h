// SPDX-License-Identifier: MIT
// Which width of the tree suits a device: measured.
#pragma once

#include <map>

#include "study/device_bench.h"

namespace strahl {

struct TunedTier {
  Precision precision = Precision::robust;
  std::map<int, double> mrays;  ///< By width: million rays a second, the geometric mean over the kinds of rays.
  int best = 0;
};

/// Widths in turns in every tier that the device has; nothing is remembered. `side`: as bench_device. Devices that run
/// work-items in lanes are asked for 2 and 4 only: there, programs of 8 and 16 lanes take minutes to build.
[[nodiscard]] std::vector<TunedTier> tune(const Device& device, const Scene& scene, int side = 0,
                                          const BenchProgress& progress = {});

}  // namespace strahl
