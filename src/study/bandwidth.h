// SPDX-License-Identifier: MIT
// How fast a device moves memory.
#pragma once

#include "opencl/device.h"

namespace strahl {

struct Bandwidth {
  double read = 0;  ///< Bytes a second by cl/kernels/bandwidth.cl.
  double copy = 0;  ///< Bytes copied a second by the driver's own copy within the device: each is read and written.
};

/// Of 256 MiB, or a quarter of what one buffer may hold; the best of a few times. Throws DeviceError where the device
/// sums wrongly.
[[nodiscard]] Bandwidth measure_bandwidth(const Device& device);

}  // namespace strahl
