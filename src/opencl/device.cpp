// SPDX-License-Identifier: MIT
// Opening the device that a selector means, and telling what to do where there is none.
#include "opencl/device.h"

#include <fmt/format.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): setenv is POSIX

#include <algorithm>

#include "opencl/driver_files.h"
#include "opencl/platforms.h"
#include "opencl/program_shelf.h"
#include "opencl/selector.h"

namespace strahl {

namespace {

constexpr const char* what_to_install =
    "install a driver: `apt install pocl-opencl-icd` for any CPU, or the OpenCL driver of your GPU";

/// Everything there is, a line each; asks every platform, so only for a message.
std::string everything_there_is() {
  std::string text;
  for (const PlatformInfo& platform : list_platforms()) {
    for (const DeviceInfo& device : platform.devices) {
      text += fmt::format("\n  {}, {}{}{}", device.text(), device.type, device.fp64 ? ", fp64" : "",
                          device.available ? "" : ", not usable");
    }
    if (!platform.skipped.empty()) {
      text += fmt::format("\n  {} {}: skipped: {}", platform.index, platform.name, platform.skipped);
    }
  }
  return text;
}

/// Drivers that are installed and cannot be loaded, a line each. Throws Error where memory is what they lack.
std::string drivers_not_loaded() {
  std::string text;
  for (const UnloadableDriver& driver : unloadable_drivers()) {
    if (driver.out_of_memory)
      throw Error(
          fmt::format("out of memory: the OpenCL driver {} cannot be loaded ({}); raise the limit of this process's "
                      "memory (ulimit -v), or free some",
                      driver.library, driver.why));
    text += fmt::format("\n  {} cannot be loaded: {}", driver.library, driver.why);
  }
  return text;
}

[[noreturn]] void throw_no_match(const std::string& selector) {
  const std::string there_is = everything_there_is() + drivers_not_loaded();
  if (there_is.empty()) throw NoDeviceError(fmt::format("there is no OpenCL platform; {}", what_to_install));
  const std::string wanted =
      selector.empty() ? "no OpenCL device can be used" : fmt::format("no OpenCL device matches \"{}\"", selector);
  throw NoDeviceError(
      fmt::format("{}; there is:{}\nname one of them by its index (\"0\", \"0:1\"), its type (\"cpu\", "
                  "\"gpu\") or a part of its name, or {}",
                  wanted, there_is, what_to_install));
}

[[noreturn]] void throw_unusable(const DeviceInfo& device) {
  if (!device.fault.empty())
    throw NoDeviceError(fmt::format("{} cannot be used: {}; there is:{}\notherwise {}", device.text(), device.fault,
                                    everything_there_is(), what_to_install));
  throw NoDeviceError(
      fmt::format("{} cannot be used: it is not available, has no compiler or is older than OpenCL 1.2 "
                  "(it says \"{}\"); there is:{}\notherwise {}",
                  device.text(), device.version, everything_there_is(), what_to_install));
}

[[noreturn]] void throw_no_fp64(const DeviceInfo& device) {
  std::string others;
  for (const PlatformInfo& platform : list_platforms()) {
    for (const DeviceInfo& other : platform.devices) {
      if (other.fp64 && other.available) others += fmt::format("\n  {}", other.text());
    }
  }
  throw NoDeviceError(fmt::format(
      "{} has no double precision (fp64), which is asked for; {}", device.text(),
      others.empty() ? fmt::format("no other device here has it; {}", what_to_install) : "these have it:" + others));
}

}  // namespace

Device Device::open(const std::string& selector_text, const DeviceNeeds& needs) {
  const DeviceSelector selector = parse_selector(selector_text);
  const std::vector<cl::Platform> handles = platform_handles();
  std::vector<PlatformInfo> platforms;
  for (const cl::Platform& handle : handles) {
    platforms.push_back(name_platform(handle, static_cast<int>(platforms.size())));
  }
  for (const std::size_t i : platforms_to_ask(selector, platforms)) add_devices(handles[i], platforms[i]);

  const std::vector<DeviceInfo> matches = matching_devices(selector, platforms);
  if (matches.empty()) throw_no_match(selector_text);
  if (!matches.front().available) throw_unusable(matches.front());
  const auto chosen = std::find_if(matches.begin(), matches.end(), [&needs](const DeviceInfo& device) {
    return device.available && (device.fp64 || !needs.fp64);
  });
  if (chosen == matches.end()) throw_no_fp64(matches.front());

  Device device;
  device.info_ = *chosen;
  if (needs.most_memory) {
    device.info_.is_memory_limited = *needs.most_memory < device.info_.global_memory;
    device.info_.global_memory = std::min(device.info_.global_memory, *needs.most_memory);
    device.info_.max_allocation = std::min(device.info_.max_allocation, *needs.most_memory);
  }
  device.programs_ = std::make_shared<ProgramShelf>();
  checked(chosen->text(), [&] {
    const cl::Platform& platform = handles[static_cast<std::size_t>(chosen->platform_index)];
    device.device_ = device_handles(platform).at(static_cast<std::size_t>(chosen->device_index));
    device.context_ = cl::Context(device.device_);
    device.queue_ = cl::CommandQueue(device.context_, device.device_, CL_QUEUE_PROFILING_ENABLE);
  });
  return device;
}

}  // namespace strahl
