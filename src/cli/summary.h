// SPDX-License-Identifier: MIT
// The one line that closes a run: where the time went.
#pragma once

#include <string>

#include "render/stats.h"

namespace strahl::cli {

/// "0.42 s (load 0.01 · bvh 0.00 · ... · other 0.04)".
[[nodiscard]] std::string time_summary(const PhaseSeconds& seconds);

/// Why RunStats::error is none.
[[nodiscard]] std::string why_no_error(const RunStats& stats);

/// "RMSE 0.0042, 95 %: 0.0039-0.0045 · noise 0.0041 · 8-bit output 0.0011 · float rounding < 1e-6 · half the error:
/// 6.9 s", or why there is none. png_bits: 0 where the file keeps floats.
[[nodiscard]] std::string error_summary(const RunStats& stats, int png_bits);

/// What -v adds: device, program and whether it came from the cache, launches.
[[nodiscard]] std::string kernel_summary(const RunStats& stats);

}  // namespace strahl::cli
