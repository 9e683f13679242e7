// SPDX-License-Identifier: MIT
// What a device's arithmetic is good for, asked of the device itself (cl/kernels/canary.cl) and never of its claims: an
// operation that is not what IEEE 754 says makes a tier of precision degraded or refused.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "opencl/device.h"
#include "opencl/program.h"
#include "settings/settings.h"
#include "trust/tier_verdict.h"

namespace strahl {

/// One property of arithmetic, as measured.
struct CanaryFinding {
  std::string property;
  int cases = 0;
  int wrong = 0;
  Verdict verdict = Verdict::holds;  ///< What it makes of the tier; holds for properties that are only recorded.
  std::string detail;                ///< A wrong case, or what was recorded.
};

struct CanaryReport {
  TierVerdict tier;
  std::vector<CanaryFinding> findings;
};

struct CanaryOptions {
  std::optional<int> lanes;  ///< None: 1 and what the device renders with.
  /// Changes the program before it is built, for tests of the canary itself.
  std::function<void(ProgramSource&)> change;
};

/// Runs the probes in the program of that tier. A device without fp64 refuses Precision::fp64.
[[nodiscard]] CanaryReport run_canary(const Device& device, Precision precision, const CanaryOptions& options = {});

}  // namespace strahl
