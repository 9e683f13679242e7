// SPDX-License-Identifier: MIT
// Device selectors on made-up platforms: which platforms are asked, which device is preferred.
#include <catch2/catch.hpp>
#include <sstream>

#include "opencl/selector.h"

using namespace strahl;

namespace {

DeviceInfo device(int platform, int index, const std::string& name, const std::string& type, unsigned units,
                  unsigned clock) {
  DeviceInfo info;
  info.platform_index = platform;
  info.device_index = index;
  info.name = name;
  info.vendor = "Vendor of " + name;
  info.type = type;
  info.compute_units = units;
  info.clock_mhz = clock;
  return info;
}

std::vector<PlatformInfo> machine() {
  std::vector<PlatformInfo> platforms(4);
  const char* names[] = {"Portable Computing Language", "rusticl", "Clover", "Intel(R) OpenCL"};
  for (int i = 0; i < 4; ++i) {
    platforms[static_cast<std::size_t>(i)].index = i;
    platforms[static_cast<std::size_t>(i)].name = names[i];
  }
  platforms[0].devices = {device(0, 0, "pthread-Intel Xeon", "CPU", 8, 3000)};
  platforms[1].devices = {device(1, 0, "llvmpipe", "CPU", 8, 0), device(1, 1, "Small Radeon", "GPU", 4, 1000),
                          device(1, 2, "Large Radeon", "GPU", 40, 1000)};
  platforms[2].skipped = "no devices";
  platforms[3].devices = {device(3, 0, "Xeon", "CPU", 8, 2900)};
  return platforms;
}

/// "1:2 1:1": what the selector means, best first.
std::string meant(const std::string& selector, const std::vector<PlatformInfo>& platforms = machine()) {
  std::ostringstream text;
  const char* space = "";
  for (const DeviceInfo& info : matching_devices(parse_selector(selector), platforms)) {
    text << space << info.platform_index << ':' << info.device_index;
    space = " ";
  }
  return text.str();
}

std::vector<std::size_t> asked(const std::string& selector) {
  return platforms_to_ask(parse_selector(selector), machine());
}

}  // namespace

TEST_CASE("The fastest GPU comes first, then CPUs") {
  CHECK(meant("") == "1:2 1:1 0:0 3:0 1:0");
  CHECK(meant("gpu") == "1:2 1:1");
  CHECK(meant("CPU") == "0:0 3:0 1:0");
  std::vector<PlatformInfo> platforms = machine();
  platforms[1].devices[2].shares_host_memory = true;
  CHECK(meant("", platforms) == "1:1 1:2 0:0 3:0 1:0");
}

TEST_CASE("A number that is no platform's index is a part of a name") {
  std::vector<PlatformInfo> platforms = machine();
  platforms[1].devices.push_back(device(1, 3, "GeForce RTX 4090", "GPU", 128, 2500));
  platforms[3].devices.push_back(device(3, 1, "Arc A1", "GPU", 32, 2000));
  CHECK(meant("4090", platforms) == "1:3");
  CHECK(meant("4091", platforms).empty());
  CHECK(meant("1", platforms) == "1:3 1:2 1:1 1:0");  // And not the Arc.
  CHECK(meant("4090:0", platforms).empty());
}

TEST_CASE("Indices") {
  CHECK(meant("0") == "0:0");
  CHECK(meant("1") == "1:2 1:1 1:0");
  CHECK(meant("1:1") == "1:1");
  CHECK(meant("1:3").empty());
  CHECK(meant("4").empty());
  CHECK(meant("2").empty());
  CHECK(meant("99999999999").empty());
  CHECK(meant("-1").empty());
  CHECK(meant("0:").empty());
  CHECK(meant("0:x").empty());
}

TEST_CASE("Names of platforms, devices and vendors, in any case") {
  CHECK(meant("pocl") == "0:0");
  CHECK(meant("PoCL") == "0:0");
  CHECK(meant("portable") == "0:0");
  CHECK(meant("RUSTICL") == "1:2 1:1 1:0");
  CHECK(meant("radeon") == "1:2 1:1");
  CHECK(meant("vendor of llvm") == "1:0");
  CHECK(meant("quantum").empty());
}

TEST_CASE("intel names the platform, never the processor under another platform") {
  CHECK(meant("intel") == "3:0");
  auto without_intel = machine();
  without_intel.pop_back();
  CHECK(meant("intel", without_intel).empty());
  CHECK(meant("intel xeon", without_intel) == "0:0");
}

TEST_CASE("Only the platform asked for is opened") {
  using Positions = std::vector<std::size_t>;
  CHECK(asked("pocl") == Positions{0});
  CHECK(asked("1") == Positions{1});
  CHECK(asked("1:0") == Positions{1});
  CHECK(asked("clover") == Positions{2});
  CHECK(asked("7") == asked(""));  // It may be a part of a name.
  CHECK(asked("7:0").empty());
  CHECK(asked("intel") == Positions{3});
  CHECK(asked("llvmpipe") == Positions{0, 1, 2, 3});
  CHECK(asked("gpu") == Positions{0, 1, 2, 3});
  CHECK(asked("") == Positions{0, 1, 2, 3});
}

TEST_CASE("A device that cannot be used comes last") {
  auto platforms = machine();
  platforms[1].devices[2].available = false;
  CHECK(meant("", platforms) == "1:1 0:0 3:0 1:0 1:2");
}
