// SPDX-License-Identifier: MIT
// Finding and opening real devices: PoCL and rusticl, which may not be missing.
#include <sched.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "errors.h"
#include "opencl/device.h"
#include "support/devices.h"

using namespace strahl;
namespace fs = std::filesystem;

namespace {

DeviceInfo opened(const std::string& selector, DeviceNeeds needs = {}) { return Device::open(selector, needs).info(); }

const PlatformInfo& platform_named(const std::vector<PlatformInfo>& platforms, const std::string& name) {
  for (const PlatformInfo& platform : platforms) {
    if (platform.name == name) return platform;
  }
  throw std::runtime_error("no platform " + name);
}

std::string refusal(const std::string& selector, DeviceNeeds needs = {}) {
  try {
    opened(selector, needs);
  } catch (const NoDeviceError& error) {
    CHECK(error.exit_code() == ExitCode::no_device);
    return error.what();
  }
  return "opened";
}

}  // namespace

TEST_CASE("Platforms are listed with their devices or the reason why there are none") {
  test::require_pocl_and_rusticl();
  const auto platforms = list_platforms();
  for (const PlatformInfo& platform : platforms) {
    INFO(platform.name);
    CHECK(platform.devices.empty() != platform.skipped.empty());
  }
  const DeviceInfo& pocl = platform_named(platforms, "Portable Computing Language").devices.at(0);
  CHECK(pocl.type == "CPU");
  CHECK(pocl.fp64);
  CHECK(pocl.available);
  CHECK(pocl.compute_units > 0);
  CHECK(pocl.global_memory > (1u << 20));
  CHECK(pocl.max_allocation <= pocl.global_memory);
  CHECK(pocl.max_work_group > 0);
  CHECK(pocl.native_vector_width > 0);
  CHECK(pocl.version.rfind("OpenCL ", 0) == 0);
  CHECK_FALSE(platform_named(platforms, "rusticl").devices.at(0).fp64);
}

TEST_CASE("A device is opened by platform, by device, by type and by index") {
  test::require_pocl_and_rusticl();
  const DeviceInfo pocl = opened("pocl");
  CHECK(pocl.platform == "Portable Computing Language");
  const DeviceInfo llvmpipe = opened("LLVMpipe");
  CHECK(llvmpipe.platform == "rusticl");
  CHECK(opened("rusticl").name == llvmpipe.name);
  CHECK(opened("cpu").type == "CPU");
  CHECK_FALSE(opened("").name.empty());
  const std::string platform = std::to_string(llvmpipe.platform_index);
  CHECK(opened(platform).name == llvmpipe.name);
  CHECK(opened(platform + ":0").name == llvmpipe.name);
  CHECK(llvmpipe.text() == platform + ":0 " + llvmpipe.name + " (rusticl)");
}

TEST_CASE("An open device computes, and its queue measures") {
  test::require_pocl_and_rusticl();
  for (const std::string& selector : test::present_devices()) {
    INFO(selector);
    const Device device = Device::open(selector);
    const std::vector<int> sent = {1, 2, 3};
    std::vector<int> received(3);
    const cl::Buffer buffer(device.context(), CL_MEM_READ_WRITE, 12);
    cl::Event event;
    device.queue().enqueueWriteBuffer(buffer, CL_TRUE, 0, 12, sent.data());
    device.queue().enqueueReadBuffer(buffer, CL_TRUE, 0, 12, received.data(), nullptr, &event);
    CHECK(received == sent);
    CHECK(event.getProfilingInfo<CL_PROFILING_COMMAND_END>() >= event.getProfilingInfo<CL_PROFILING_COMMAND_START>());
  }
}

TEST_CASE("PoCL launches what a program's binary holds, unless the user wants otherwise") {
  test::require_pocl_and_rusticl();
  constexpr const char* name = "POCL_WORK_GROUP_SPECIALIZATION";
  opened("pocl");
  REQUIRE(std::getenv(name) != nullptr);
  const std::string setting = std::getenv(name);
  // What this process was begun with; tests.cmake begins one more with a 1.
  std::ifstream begun("/proc/self/environ");
  std::string wanted = "0";
  for (std::string entry; std::getline(begun, entry, '\0');)
    if (entry.starts_with(std::string(name) + "=")) wanted = entry.substr(entry.find('=') + 1);
  CHECK(setting == wanted);
  // Threads of drivers may read the environment by now, so it stays as it is.
  unsetenv(name);
  opened("pocl");
  CHECK(std::getenv(name) == nullptr);
  setenv(name, "1", 1);
  opened("pocl");
  CHECK(std::string(std::getenv(name)) == "1");
  setenv(name, setting.c_str(), 1);
}

TEST_CASE("PoCL's threads have a processor each, where nothing says otherwise") {
  test::require_pocl_and_rusticl();
  const DeviceInfo device = opened("pocl");
  cpu_set_t allowed;
  REQUIRE(sched_getaffinity(0, sizeof allowed, &allowed) == 0);
  if (std::getenv("POCL_MAX_PTHREAD_COUNT") != nullptr || CPU_COUNT(&allowed) != sysconf(_SC_NPROCESSORS_CONF)) {
    WARN("the environment limits PoCL's threads, or this process has a part of the processors");
    return;
  }
  REQUIRE(std::getenv("POCL_AFFINITY") != nullptr);
  if (std::string(std::getenv("POCL_AFFINITY")) != "1") {
    WARN("POCL_AFFINITY leaves the threads free");
    return;
  }
  std::set<std::string> processors;  // Of threads that have one only.
  for (const auto& thread : fs::directory_iterator("/proc/self/task")) {
    std::ifstream status(thread.path() / "status");
    const std::string label = "Cpus_allowed_list:\t";
    for (std::string line; std::getline(status, line);)
      if (line.rfind(label, 0) == 0 && line.find_first_of(",-", label.size()) == std::string::npos)
        processors.insert(line.substr(label.size()));
  }
  CHECK(processors.size() == device.compute_units);
}

TEST_CASE("An unknown selector is answered with what there is") {
  test::require_pocl_and_rusticl();
  const std::string message = refusal("quantum");
  CHECK_THAT(message, Catch::Contains("no OpenCL device matches \"quantum\""));
  CHECK_THAT(message, Catch::Contains(opened("pocl").text()));
  CHECK_THAT(message, Catch::Contains(opened("llvmpipe").text()));
  CHECK_THAT(message, Catch::Contains("pocl-opencl-icd"));
  CHECK_THAT(refusal("0:99"), Catch::Contains("no OpenCL device matches \"0:99\""));
}

TEST_CASE("Double precision is refused where it is missing, and the message names who has it") {
  test::require_pocl_and_rusticl();
  const std::string message = refusal("llvmpipe", {.fp64 = true});
  CHECK_THAT(message, Catch::Contains("no double precision (fp64)"));
  CHECK_THAT(message, Catch::Contains(opened("llvmpipe").text()));
  CHECK_THAT(message, Catch::Contains("these have it:\n"));
  CHECK_THAT(message, Catch::Contains(opened("pocl").text()));
  CHECK(opened("pocl", {.fp64 = true}).fp64);
  CHECK(opened("", {.fp64 = true}).fp64);
}
