// SPDX-License-Identifier: MIT
// OpenCL's answers turned into PlatformInfo and DeviceInfo, a driver's failures into reasons.
#include "opencl/platforms.h"

#include <fmt/format.h>

#include <cstdio>

#include "opencl/cl_code.h"
#include "opencl/driver_environment.h"

namespace strahl {

namespace {

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\n");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\n") - first + 1);
}

std::string type_name(cl_device_type type) {
  if (type & CL_DEVICE_TYPE_GPU) return "GPU";
  if (type & CL_DEVICE_TYPE_CPU) return "CPU";
  if (type & CL_DEVICE_TYPE_ACCELERATOR) return "accelerator";
  return "custom";
}

/// Kernels are OpenCL C 1.2. CL_DEVICE_VERSION reads "OpenCL 3.0 PoCL ...".
bool speaks_opencl_1_2(const std::string& version) {
  int major = 0;
  int minor = 0;
  if (std::sscanf(version.c_str(), "OpenCL %d.%d", &major, &minor) != 2) return false;
  return major > 1 || (major == 1 && minor >= 2);
}

/// The question is deprecated since OpenCL 2.0; of a driver that has no answer the device counts as a card.
bool shares_host_memory(const cl::Device& device) {
  cl_bool shares = CL_FALSE;
  return clGetDeviceInfo(device(), CL_DEVICE_HOST_UNIFIED_MEMORY, sizeof shares, &shares, nullptr) == CL_SUCCESS &&
         shares == CL_TRUE;
}

/// Drivers before OpenCL 1.2 have no answer for devices without fp64.
bool has_fp64(const cl::Device& device) {
  cl_device_fp_config config = 0;
  const cl_int code = clGetDeviceInfo(device(), CL_DEVICE_DOUBLE_FP_CONFIG, sizeof config, &config, nullptr);
  if (code != CL_SUCCESS && code != CL_INVALID_VALUE) throw cl::Error(code, "clGetDeviceInfo");
  return code == CL_SUCCESS && config != 0;
}

/// Throws cl::Error where the driver has no answer, with what is known by then in `info`.
void ask(const cl::Device& device, DeviceInfo& info) {
  info.name = trimmed(device.getInfo<CL_DEVICE_NAME>());
  info.vendor = trimmed(device.getInfo<CL_DEVICE_VENDOR>());
  info.version = trimmed(device.getInfo<CL_DEVICE_VERSION>());
  info.driver = trimmed(device.getInfo<CL_DRIVER_VERSION>());
  info.type = type_name(device.getInfo<CL_DEVICE_TYPE>());
  info.fp64 = has_fp64(device);
  const cl_device_fp_config single = device.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>();
  info.correctly_rounded_option = (single & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT) != 0;
  info.fma = (single & CL_FP_FMA) != 0;
  info.compute_units = device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>();
  info.clock_mhz = device.getInfo<CL_DEVICE_MAX_CLOCK_FREQUENCY>();
  info.global_memory = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
  info.shares_host_memory = shares_host_memory(device);
  info.max_allocation = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
  info.max_work_group = device.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>();
  info.native_vector_width = device.getInfo<CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT>();
  info.available = device.getInfo<CL_DEVICE_AVAILABLE>() == CL_TRUE &&
                   device.getInfo<CL_DEVICE_COMPILER_AVAILABLE>() == CL_TRUE && speaks_opencl_1_2(info.version);
}

std::string failure(const cl::Error& error) {
  return fmt::format("{} failed with {}", error.what(), cl_code_name(error.err()));
}

/// One device that cannot be described hides no other.
DeviceInfo describe(const cl::Device& device, const PlatformInfo& platform, int index) {
  DeviceInfo info;
  info.platform_index = platform.index;
  info.device_index = index;
  info.platform = platform.name;
  try {
    ask(device, info);
  } catch (const cl::Error& error) {
    info.available = false;
    info.fault = failure(error);
  }
  return info;
}

}  // namespace

std::vector<cl::Platform> platform_handles() {
  prepare_driver_environment();
  std::vector<cl::Platform> platforms;
  try {
    cl::Platform::get(&platforms);
  } catch (const cl::Error& error) {
    if (error.err() != CL_PLATFORM_NOT_FOUND_KHR) throw DeviceError(error.what(), error.err(), "the OpenCL loader");
    return {};  // the loader's way to say "none"
  }
  return platforms;
}

PlatformInfo name_platform(const cl::Platform& platform, int index) {
  PlatformInfo info;
  info.index = index;
  try {
    info.name = trimmed(platform.getInfo<CL_PLATFORM_NAME>());
    info.version = trimmed(platform.getInfo<CL_PLATFORM_VERSION>());
  } catch (const cl::Error& error) {
    info.skipped = failure(error);
  }
  return info;
}

void add_devices(const cl::Platform& platform, PlatformInfo& info) {
  if (!info.skipped.empty()) return;
  try {
    for (const cl::Device& device : device_handles(platform)) {
      info.devices.push_back(describe(device, info, static_cast<int>(info.devices.size())));
    }
  } catch (const cl::Error& error) {
    info.devices.clear();
    info.skipped = failure(error);
    return;
  }
  const std::string& cache = prepare_driver_environment();
  const bool is_pocl = info.name == "Portable Computing Language";
  if (is_pocl) info.note = cache;
  if (!info.devices.empty()) return;
  info.skipped = "no devices";
  if (is_pocl && !cache.empty()) info.skipped += "; " + cache;
  if (info.name == "rusticl") {
    info.skipped +=
        "; Mesa's rusticl offers the drivers that the environment names: RUSTICL_ENABLE=llvmpipe for the CPU";
  }
}

std::vector<cl::Device> device_handles(const cl::Platform& platform) {
  std::vector<cl::Device> devices;
  try {
    platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
  } catch (const cl::Error& error) {
    if (error.err() != CL_DEVICE_NOT_FOUND) throw;
    return {};  // a platform's way to say "none"
  }
  return devices;
}

std::string DeviceInfo::text() const {
  return fmt::format("{}:{} {} ({})", platform_index, device_index, name, platform);
}

std::string DeviceInfo::memory_text() const {
  const bool is_little = global_memory < 1U << 20;
  return fmt::format("{} {}{}", global_memory >> (is_little ? 10 : 20), is_little ? "KiB" : "MiB",
                     is_memory_limited ? " by --memory-limit" : "");
}

std::string DeviceInfo::room_for(std::uint64_t bytes) const {
  return is_memory_limited && bytes > global_memory ? "a larger --memory-limit" : "a device with more memory (-d)";
}

std::vector<PlatformInfo> list_platforms() {
  std::vector<PlatformInfo> infos;
  for (const cl::Platform& platform : platform_handles()) {
    infos.push_back(name_platform(platform, static_cast<int>(infos.size())));
    add_devices(platform, infos.back());
  }
  return infos;
}

}  // namespace strahl
