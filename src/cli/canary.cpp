// SPDX-License-Identifier: MIT
#include "cli/canary.h"

#include <fmt/format.h>

#include "cli/console.h"
#include "stopwatch.h"

namespace strahl::cli {

TierChoice trusted_tier(const Device& device, std::optional<Precision> named) try {
  return choose_tier(device, named);
} catch (const NoDeviceError& error) {
  throw NoDeviceError(fmt::format("{}; {}-d chooses a device, --no-canary renders nevertheless", error.what(),
                                  named ? "--precision chooses a precision, " : ""));
}

Canary ask_canary(const Device& device, const KernelOptions& options, RenderSettings& settings) {
  if (options.no_canary) return {};
  const Stopwatch start;
  std::optional<Precision> named;
  if (options.precision) named = settings.precision;
  const TierChoice choice = trusted_tier(device, named);
  settings.precision = choice.tier.precision;
  settings.loop_turns = choice.tier.loop_turns;
  if (!choice.instead.empty())
    say(fmt::format("strahl: warning: --precision {} on {}: {}", precision_name(settings.precision),
                    device.info().text(), choice.instead));
  return {CanaryStats{verdict_name(choice.tier.verdict), choice.tier.why, choice.instead}, start.seconds()};
}

}  // namespace strahl::cli
