// SPDX-License-Identifier: MIT
// What a tier of precision may promise on a device.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "settings/settings.h"

namespace strahl {

enum class Verdict {
  holds,
  degraded,  ///< Usable; what it promises holds with a limit that is named.
  refused,   ///< What it promises does not hold.
};

[[nodiscard]] const char* verdict_name(Verdict verdict);

struct TierVerdict {
  Precision precision = Precision::stable;
  Verdict verdict = Verdict::holds;
  std::string why;  ///< Empty where it holds.
  /// Turns in sum over all loops of a work-item after which the device ends them; none: more than the canary asks for.
  /// For RenderSettings::loop_turns.
  std::optional<std::uint64_t> loop_turns;
};

}  // namespace strahl
