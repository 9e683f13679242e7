// SPDX-License-Identifier: MIT
// When this process began: what an outside clock would say, not when main was reached.
#pragma once

#include "render/goal.h"

namespace strahl::cli {

/// Linux records the start in ticks of 10 ms, exec keeps it (so a launcher counts too); within the tick the processor
/// time spent so far tells the rest. Elsewhere: now. Call early.
[[nodiscard]] Clock::time_point process_start();

}  // namespace strahl::cli
