// SPDX-License-Identifier: MIT
// What a scene takes on a device, told from counts before anything is built, packed or compiled for it.
#pragma once

#include <cstdint>

#include "opencl/device.h"
#include "program/features.h"
#include "scene/model/scene.h"
#include "settings/settings.h"

namespace strahl {

/// Bytes of the three buffers, the least that they can be: leaves that are not full and the nodes of a tree come on
/// top.
struct MemoryNeed {
  std::uint64_t geometry = 0, shading = 0, index = 0;

  [[nodiscard]] std::uint64_t total() const { return geometry + shading + index; }
};

/// Every group counts once, however often it is placed.
[[nodiscard]] MemoryNeed least_memory(const Scene& scene, const Features& features, Precision precision, int lanes);

/// Whether the device can hold so much, all of it together and each of the buffers.
[[nodiscard]] bool fits(const MemoryNeed& need, const DeviceInfo& device);

/// Throws NoDeviceError, with need, limits and remedy, where it does not fit.
void require_memory(const MemoryNeed& need, const DeviceInfo& device, Precision precision);

}  // namespace strahl
