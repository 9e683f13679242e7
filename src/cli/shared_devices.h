// SPDX-License-Identifier: MIT
// `-d 0,1`: several devices for one picture.
#pragma once

#include <string>
#include <vector>

#include "cli/render_options.h"
#include "opencl/device.h"
#include "render/renderer.h"

namespace strahl::cli {

/// The selectors of -d, between commas; one within brackets is part of a name ("llvmpipe (LLVM 15.0.6, 256 bits)").
/// Throws UsageError where one is empty beside others, or where the options are for one device.
[[nodiscard]] std::vector<std::string> device_selectors(const RenderOptions& options);

/// One that takes part, and the picture's settings there: loop_turns are the device's own.
struct SharedDevice {
  Device device;
  RenderSettings settings;
};

/// Opens all selectors after the first and has them take part. `settings` are those on the first. Returns all devices.
/// Throws UsageError for a device that is named twice, else as Device::open and choose_tier.
[[nodiscard]] std::vector<SharedDevice> share(Renderer& renderer, const Device& first,
                                              const std::vector<std::string>& selectors, const DeviceNeeds& needs,
                                              const KernelOptions& options, const RenderSettings& settings);

[[nodiscard]] std::vector<Device> devices_of(const std::vector<SharedDevice>& all);

/// Devices that were dropped: said even with -q.
void warn_of_dropped(const RunStats& stats);

/// The first that was not dropped; the first where there are no others.
[[nodiscard]] const SharedDevice& living(const std::vector<SharedDevice>& devices, const RunStats& stats);

}  // namespace strahl::cli
