// SPDX-License-Identifier: MIT
#include "cli/shared_devices.h"

#include <fmt/format.h>

#include "cli/canary.h"
#include "cli/console.h"
#include "errors.h"

namespace strahl::cli {

std::vector<std::string> device_selectors(const RenderOptions& options) {
  std::vector<std::string> all{""};
  int depth = 0;
  for (const char c : options.device) {
    depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    if (c == ',' && depth == 0)
      all.emplace_back();
    else
      all.back() += c;
  }
  if (all.size() == 1) return all;
  for (const std::string& one : all)
    if (one.empty()) throw UsageError(fmt::format("-d \"{}\": a device's name is empty", options.device));
  if (options.goal.frames) throw UsageError("--frames renders on one device, and -d names several");
  if (options.goal.dry_run) throw UsageError("--dry-run predicts what one device takes, and -d names several");
  return all;
}

std::vector<Device> share(Renderer& renderer, const Device& first, const std::vector<std::string>& selectors,
                          const DeviceNeeds& needs, const KernelOptions& options, const RenderSettings& settings) {
  std::vector<Device> all{first};
  for (std::size_t i = 1; i < selectors.size(); ++i) {
    const Device device = Device::open(selectors[i], needs);
    for (const Device& other : all)
      if (other.device()() == device.device()())
        throw UsageError(fmt::format("-d names {} twice", device.info().text()));
    std::optional<std::uint64_t> loop_turns;
    if (!options.no_canary) loop_turns = trusted_tier(device, settings.precision).tier.loop_turns;
    renderer.share_with(device, loop_turns);
    all.push_back(device);
  }
  return all;
}

void warn_of_dropped(const RunStats& stats) {
  for (const DeviceShare& share : stats.shares)
    if (!share.fault.empty())
      say(fmt::format("strahl: warning: {} was dropped, and the other devices did its part: {}", share.device,
                      share.fault));
}

const Device& living(const std::vector<Device>& devices, const RunStats& stats) {
  for (std::size_t i = 0; i < stats.shares.size(); ++i)
    if (stats.shares[i].fault.empty()) return devices.at(i);
  return devices.front();
}

}  // namespace strahl::cli
