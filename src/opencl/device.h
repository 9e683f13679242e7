// SPDX-License-Identifier: MIT
// Finding and opening an OpenCL device.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "opencl/opencl.h"

namespace strahl {

/// What is known of a device before it is opened.
struct DeviceInfo {
  int platform_index = 0;
  int device_index = 0;  ///< Within its platform.
  std::string platform;  ///< "Portable Computing Language"
  std::string name;
  std::string vendor;
  std::string version;  ///< CL_DEVICE_VERSION
  std::string driver;
  std::string type;  ///< "CPU", "GPU", "accelerator", "custom"
  bool fp64 = false;
  bool correctly_rounded_option = false;  ///< Knows -cl-fp32-correctly-rounded-divide-sqrt.
  bool fma = false;                       ///< In single precision; else programs compute it (cl/math/soft_fma.h).
  unsigned compute_units = 0;
  unsigned clock_mhz = 0;
  std::uint64_t global_memory = 0;   ///< bytes; of an open device no more than DeviceNeeds::most_memory
  std::uint64_t max_allocation = 0;  ///< bytes
  bool shares_host_memory = false;   ///< As processors do, and GPUs that are a part of one.
  bool is_memory_limited = false;    ///< DeviceNeeds::most_memory is less than it has.
  std::size_t max_work_group = 0;
  unsigned native_vector_width = 0;  ///< CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT
  bool available = true;             ///< The driver says so, has a compiler, and speaks OpenCL 1.2 or later.
  std::string fault;                 ///< Why nobody knows whether it is available; empty where its driver answers.

  /// "0:1 llvmpipe (rusticl)".
  [[nodiscard]] std::string text() const;
  /// In messages about its memory: "449 MiB", "48 KiB by --memory-limit".
  [[nodiscard]] std::string memory_text() const;
  /// What has room for so many bytes where it has not: "a larger --memory-limit", "a device with more memory (-d)".
  [[nodiscard]] std::string room_for(std::uint64_t bytes) const;
};

struct PlatformInfo {
  int index = 0;
  std::string name;
  std::string version;
  std::vector<DeviceInfo> devices;
  std::string skipped;  ///< Why the platform offers nothing; empty where it does.
  std::string note;     ///< What is other than its driver has it by default; mostly empty.
};

/// Every platform, the broken and empty ones too, with the reason. Never throws for a platform's fault. Changes the
/// environment as Device::open does.
[[nodiscard]] std::vector<PlatformInfo> list_platforms();

class ProgramShelf;

/// What a render asks of a device.
struct DeviceNeeds {
  bool fp64 = false;
  /// Bytes that buffers may take there, all together; none: what the device has.
  std::optional<std::uint64_t> most_memory = std::nullopt;
};

/// An open device: one context, one in-order queue with profiling.
///
/// Before the first of Device::open and list_platforms starts the drivers, it changes this process's environment
/// (opencl/driver_environment.cpp), so no other thread may read or write it then:
///  - POCL_WORK_GROUP_SPECIALIZATION becomes 0 where it is not set, so that PoCL's cached programs are whole.
///  - POCL_AFFINITY becomes 1 where it is not set, so that each of PoCL's threads keeps to a processor; not where
///    POCL_MAX_PTHREAD_COUNT is set or the process may not run on all processors.
///  - POCL_CACHE_DIR names a folder among the temporary files where PoCL could not write its default cache. One that is
///    set stays, but an empty one is removed: PoCL 3.1 ends the process for it.
///  - A relative XDG_CACHE_HOME is removed, as the XDG Base Directory Specification has it ignored.
class Device {
 public:
  /// selector: "" (fastest GPU, else CPU), "0", "0:1", "cpu", "gpu", or part of a platform's or device's name,
  /// case-insensitive; "pocl" and "intel" name platforms only. A platform's name goes before a device's; of several
  /// devices the best is taken: GPU before CPU, a GPU with memory of its own before one that is a part of the
  /// processor, then compute units times clock. Opens only the platform asked for. Throws NoDeviceError: what is
  /// missing, what to install, which devices would do.
  static Device open(const std::string& selector, const DeviceNeeds& needs = {});

  [[nodiscard]] const DeviceInfo& info() const { return info_; }
  [[nodiscard]] const cl::Context& context() const { return context_; }
  [[nodiscard]] const cl::Device& device() const { return device_; }
  [[nodiscard]] const cl::CommandQueue& queue() const { return queue_; }
  /// Copies of a device share it; its header is not installed (opencl/program_shelf.h).
  [[nodiscard]] ProgramShelf& programs() const { return *programs_; }

 private:
  DeviceInfo info_;
  cl::Device device_;
  cl::Context context_;
  cl::CommandQueue queue_;
  std::shared_ptr<ProgramShelf> programs_;
};

}  // namespace strahl
