// SPDX-License-Identifier: MIT
// The OpenCL devices that tests may use.
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "opencl/device.h"

namespace strahl::test {

/// What a selector means has that in the name of its platform, llvmpipe in the device's: rusticl has others.
inline bool is_there(const std::vector<PlatformInfo>& platforms, const std::string& selector, const std::string& name) {
  const bool by_device = selector == "llvmpipe";
  return std::any_of(platforms.begin(), platforms.end(), [&](const PlatformInfo& platform) {
    return std::any_of(platform.devices.begin(), platform.devices.end(), [&](const DeviceInfo& device) {
      return (by_device ? device.name : device.platform).find(name) != std::string::npos;
    });
  });
}

inline const char* const pocl_name = "Portable Computing Language";

/// Selectors of what is there, of "pocl", "llvmpipe", "intel", "oclgrind" and "gpu" (the one that strahl takes by
/// itself). In a program that runs under the `oclgrind` command, that is all there is. Call before anything else that
/// uses OpenCL: Mesa reads its environment once, and offers no llvmpipe without RUSTICL_ENABLE.
inline std::vector<std::string> present_devices() {
  setenv("RUSTICL_ENABLE", "llvmpipe", 0);
  const std::vector<std::pair<std::string, std::string>> known = {
      {"pocl", pocl_name}, {"llvmpipe", "llvmpipe"}, {"intel", "Intel"}, {"oclgrind", "Oclgrind"}};
  const std::vector<PlatformInfo> platforms = list_platforms();
  std::vector<std::string> present;
  for (const auto& [selector, name] : known)
    if (is_there(platforms, selector, name)) present.push_back(selector);
  // Oclgrind calls itself a GPU.
  const bool has_gpu = std::any_of(platforms.begin(), platforms.end(), [](const PlatformInfo& platform) {
    return platform.name.find("Oclgrind") == std::string::npos &&
           std::any_of(platform.devices.begin(), platform.devices.end(),
                       [](const DeviceInfo& device) { return device.type == "GPU" && device.available; });
  });
  if (has_gpu) present.push_back("gpu");
  return present;
}

/// Fails the test case where PoCL is missing, which may not be skipped. rusticl makes no llvmpipe unasked, which takes
/// it 0.2 s.
inline void require_pocl() {
  INFO("PoCL is missing: apt install pocl-opencl-icd");
  REQUIRE(is_there(list_platforms(), "pocl", pocl_name));
}

/// Fails the test case where PoCL or rusticl's llvmpipe is missing: those two may not be skipped.
inline void require_pocl_and_rusticl() {
  const std::vector<std::string> present = present_devices();
  for (const std::string selector : {"pocl", "llvmpipe"}) {
    INFO(selector << " is missing: apt install pocl-opencl-icd mesa-opencl-icd");
    REQUIRE(std::count(present.begin(), present.end(), selector) == 1);
  }
}

}  // namespace strahl::test
