// SPDX-License-Identifier: MIT
// Which device a user means by `-d`: the words of Device::open, decided on descriptions alone, without OpenCL.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "opencl/device.h"

namespace strahl {

/// A selector, taken apart. At most one of platform, type and name is set, but for a number alone, which is a part of a
/// name ("4090") where no platform has that index; none: any device.
struct DeviceSelector {
  std::optional<int> platform;  ///< "0", "0:1"
  std::optional<int> device;    ///< "0:1"
  std::string type;             ///< "CPU" or "GPU"
  std::string name;             ///< Lower case; part of a platform's, device's or vendor's name.
  bool names_platform = false;  ///< An alias ("pocl", "intel"): only a platform's name counts.
};

[[nodiscard]] DeviceSelector parse_selector(const std::string& text);

/// Positions of the platforms whose devices must be asked for, judged by index and name: that of the index; those
/// whose name matches; where none does, all, because it may be a device's name.
[[nodiscard]] std::vector<std::size_t> platforms_to_ask(const DeviceSelector& selector,
                                                        const std::vector<PlatformInfo>& platforms);

/// Every device that the selector means, best first: usable before unusable, GPU before CPU before accelerator, then
/// compute units × clock, then the order of the loader.
[[nodiscard]] std::vector<DeviceInfo> matching_devices(const DeviceSelector& selector,
                                                       const std::vector<PlatformInfo>& platforms);

}  // namespace strahl
