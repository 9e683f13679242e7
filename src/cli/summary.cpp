// SPDX-License-Identifier: MIT
// Statistics for people; for programs there is --stats.
#include "cli/summary.h"

#include <fmt/format.h>

#include <algorithm>

namespace strahl::cli {

std::string time_summary(const PhaseSeconds& s) {
  return fmt::format(
      "{:.2f} s (load {:.2f} · bvh {:.2f} · program {:.2f} · upload {:.2f} · kernel {:.2f} · readback {:.2f} · encode "
      "{:.2f} · other {:.2f})",
      s.total, s.load, s.bvh, s.program, s.upload, s.kernel, s.readback, s.encode, std::max(0.0, s.other()));
}

std::string kernel_summary(const RunStats& stats) {
  return fmt::format(
      "device {}\nprogram {} ({}; {}, {} lane{}), {}\nlaunches {}, the longest {:.4f} s; {:.1f} MiB on the device, "
      "{:.1f} MiB on the host",
      stats.device, stats.program, stats.program_from_cache ? "from the cache" : "built", stats.precision, stats.lanes,
      stats.lanes == 1 ? "" : "s", fmt::join(stats.features, " "), stats.kernel_runs.size(), stats.longest_launch(),
      static_cast<double>(stats.device_bytes) / (1 << 20), static_cast<double>(stats.host_bytes) / (1 << 20));
}

}  // namespace strahl::cli
