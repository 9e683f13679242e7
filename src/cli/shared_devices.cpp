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

std::vector<SharedDevice> share(Renderer& renderer, const Device& first, const std::vector<std::string>& selectors,
                                const DeviceNeeds& needs, const KernelOptions& options,
                                const RenderSettings& settings) {
  std::vector<SharedDevice> all{{first, settings}};
  for (std::size_t i = 1; i < selectors.size(); ++i) {
    const Device device = Device::open(selectors[i], needs);
    for (const SharedDevice& other : all)
      if (other.device.device()() == device.device()())
        throw UsageError(fmt::format("-d names {} twice", device.info().text()));
    RenderSettings own = settings;
    own.loop_turns.reset();
    if (!options.no_canary) own.loop_turns = trusted_tier(device, settings.precision).tier.loop_turns;
    renderer.share_with(device, own.loop_turns);
    all.push_back({device, own});
  }
  return all;
}

void warn_of_dropped(const RunStats& stats) {
  for (const DeviceShare& share : stats.shares)
    if (!share.fault.empty())
      say(fmt::format("strahl: warning: {} was dropped, and the other devices did its part: {}", share.device,
                      share.fault));
}

std::vector<Device> devices_of(const std::vector<SharedDevice>& all) {
  std::vector<Device> devices;
  for (const SharedDevice& one : all) devices.push_back(one.device);
  return devices;
}

const SharedDevice& living(const std::vector<SharedDevice>& devices, const RunStats& stats) {
  for (std::size_t i = 0; i < stats.shares.size(); ++i)
    if (stats.shares[i].fault.empty()) return devices.at(i);
  return devices.front();
}

}  // namespace strahl::cli
