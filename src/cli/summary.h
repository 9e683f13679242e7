// SPDX-License-Identifier: MIT
// The one line that closes a run: where the time went.
#pragma once

#include <string>

#include "render/stats.h"

namespace strahl::cli {

/// "0.42 s (load 0.01 · bvh 0.00 · ... · other 0.04)".
[[nodiscard]] std::string time_summary(const PhaseSeconds& seconds);

/// What -v adds: device, program and whether it came from the cache, launches.
[[nodiscard]] std::string kernel_summary(const RunStats& stats);

}  // namespace strahl::cli
