// SPDX-License-Identifier: MIT
// Which tier of precision a device is trusted with: by the verdict of its canary, a program that asks the device what
// its arithmetic is good for and whether it lets loops run to their end.
#pragma once

#include <optional>
#include <string>

#include "opencl/device.h"
#include "trust/tier_verdict.h"

namespace strahl {

/// The canary's verdict, kept beside the compiled programs per device, driver, strahl version and kernel sources. Where
/// it is not known yet the canary is compiled and run, which takes a second, with some drivers ten. Throws DeviceError
/// and KernelBuildError.
[[nodiscard]] TierVerdict tier_verdict(const Device& device, Precision precision);

struct TierChoice {
  TierVerdict tier;     ///< What is used.
  std::string instead;  ///< Why not the default tier, a sentence; empty where it is the default, or the one named.
};

/// The tier that was asked for by name, or else the first of robust, stable and fast that is not refused. Throws
/// NoDeviceError where there is none: what is wrong, and what to do.
[[nodiscard]] TierChoice choose_tier(const Device& device, std::optional<Precision> named);

}  // namespace strahl
