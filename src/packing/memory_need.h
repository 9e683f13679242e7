// SPDX-License-Identifier: MIT
// What a scene takes on a device at the least.
#pragma once

#include <cstdint>

#include "opencl/device.h"

namespace strahl {

/// Bytes of the three buffers, the least that they can be: leaves that are not full and the nodes of a tree come on
/// top.
struct MemoryNeed {
  std::uint64_t geometry = 0, shading = 0, index = 0;

  [[nodiscard]] std::uint64_t total() const { return geometry + shading + index; }
};

/// Whether the device can hold so much, all of it together and each of the buffers.
[[nodiscard]] bool fits(const MemoryNeed& need, const DeviceInfo& device);

}  // namespace strahl
