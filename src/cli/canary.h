// SPDX-License-Identifier: MIT
// The canary's verdict (trust/tier_choice.h) as `render` and `intersect` use it.
#pragma once

#include "cli/kernel_options.h"
#include "opencl/device.h"
#include "render/stats.h"
#include "trust/tier_choice.h"

namespace strahl::cli {

/// As choose_tier(); what it throws names the options that help.
[[nodiscard]] TierChoice trusted_tier(const Device& device, std::optional<Precision> named);

struct Canary {
  std::optional<CanaryStats> stats;
  double seconds = 0;

  void note_in(RunStats& run) const {
    run.canary = stats;
    run.seconds.program += seconds;
  }
};

/// Settles the precision and how long loops may be, unless --no-canary. Warns where another one stands in for the
/// default; throws NoDeviceError where what was asked for by name is refused.
[[nodiscard]] Canary ask_canary(const Device& device, const KernelOptions& options, RenderSettings& settings);

}  // namespace strahl::cli
