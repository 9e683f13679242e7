// SPDX-License-Identifier: MIT
// What a scene takes on a device, told from counts before anything is built, packed or compiled for it.
#pragma once

#include "packing/memory_need.h"
#include "program/features.h"
#include "scene/model/scene.h"
#include "settings/settings.h"

namespace strahl {

/// Every group counts once, however often it is placed.
[[nodiscard]] MemoryNeed least_memory(const Scene& scene, const Features& features, Precision precision, int lanes);

/// Throws NoDeviceError, with need, limits and remedy, where it does not fit.
void require_memory(const MemoryNeed& need, const DeviceInfo& device, Precision precision);

}  // namespace strahl
