// SPDX-License-Identifier: MIT
// When this process began: what an outside clock would say, not when main was reached.
#pragma once

#include <vector>

#include "opencl/device.h"
#include "render/goal.h"

namespace strahl::cli {

/// Linux records the start in ticks of 10 ms, exec keeps it (so a launcher counts too); within the tick the processor
/// time spent so far tells the rest. Elsewhere: now. Call early.
[[nodiscard]] Clock::time_point process_start();

/// What the operating system will take to end the process: it gives back the memory that is resident by then, and
/// `more_bytes`, at the rate at which it takes back a piece of it now. Then the driver of a GPU lets it go, which takes
/// a tenth of a second (docs/devices.md). devices: those that are open.
[[nodiscard]] double expected_exit_seconds(const std::vector<Device>& devices, double more_bytes = 0);

}  // namespace strahl::cli
