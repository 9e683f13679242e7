// SPDX-License-Identifier: MIT
// Which tier of precision a device is trusted with: by the verdict of its canary.
#pragma once

#include <optional>
#include <string>

#include "trust/canary.h"

namespace strahl {

/// The canary's verdict, kept beside the compiled programs per device, driver, strahl version and kernel sources.
[[nodiscard]] TierVerdict tier_verdict(const Device& device, Precision precision);

struct TierChoice {
  TierVerdict tier;     ///< What is used.
  std::string instead;  ///< Why not the default tier, a sentence; empty where it is the default, or the one named.
};

/// The tier that was asked for by name, or else the first of robust, stable and fast that is not refused. Throws
/// NoDeviceError where there is none: what is wrong, and what to do.
[[nodiscard]] TierChoice choose_tier(const Device& device, std::optional<Precision> named);

}  // namespace strahl
