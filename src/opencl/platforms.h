// SPDX-License-Identifier: MIT
// Asking the OpenCL loader what there is, step by step: platforms by name first, and the devices of a platform only
// when they are wanted, because asking a driver for its devices starts it (and a broken driver may fail or hang).
#pragma once

#include <vector>

#include "opencl/device.h"

namespace strahl {

/// Every platform that the loader knows, in its order; empty where there is no driver at all.
[[nodiscard]] std::vector<cl::Platform> platform_handles();

/// Name and version; no device is touched. A failure becomes the reason in `skipped`.
[[nodiscard]] PlatformInfo name_platform(const cl::Platform& platform, int index);

/// Adds the devices to what name_platform gave; a failure, or no device at all, becomes the reason in `skipped`.
void add_devices(const cl::Platform& platform, PlatformInfo& info);

/// The platform's devices in the order that DeviceInfo::device_index counts; throws cl::Error.
[[nodiscard]] std::vector<cl::Device> device_handles(const cl::Platform& platform);

}  // namespace strahl
