// SPDX-License-Identifier: MIT
// Statistics for people; for programs there is --stats.
#include "cli/summary.h"

#include <fmt/format.h>

#include <algorithm>

namespace strahl::cli {

std::string time_summary(const PhaseSeconds& s) {
  return fmt::format(
      "{:.2f} s (start {:.2f} · device {:.2f} · load {:.2f} · bvh {:.2f} · program {:.2f} · upload {:.2f} · kernel "
      "{:.2f} · readback {:.2f} · error "
      "{:.2f} · encode {:.2f} · exit {:.2f} · other {:.2f})",
      s.total, s.start, s.device, s.load, s.bvh, s.program, s.upload, s.kernel, s.readback, s.error, s.encode, s.exit,
      std::max(0.0, s.other()));
}

std::string why_no_error(const RunStats& stats) {
  if (stats.saturated_samples + stats.invalid_samples > 0) return "samples were not finite, see the warning";
  return "a pixel has fewer than 4 samples, or --no-error";
}

std::string error_summary(const RunStats& stats, int png_bits) {
  if (!stats.error) return "error not measured: " + why_no_error(stats);
  const ErrorBudget& error = *stats.error;
  std::string text = fmt::format("RMSE {:.2g}, 95 %: {:.2g}–{:.2g} · noise {:.2g}", error.rmse(), error.rmse_low(),
                                 error.rmse_high(), error.noise.rmse);
  if (png_bits > 0) text += fmt::format(" · {}-bit output {:.2g}", png_bits, error.output);
  if (error.clipping > 0) text += fmt::format(" · clipped highlights {:.2g}", error.clipping);
  if (!error.rounding)
    text += " · float rounding not measured (-v)";
  else if (*error.rounding < 1e-6)
    text += " · float rounding < 1e-6";
  else
    text += fmt::format(" · float rounding {:.2g}", *error.rounding);
  // Independent samples need four times as many; scrambled sequences at the most.
  if (error.noise.rmse > 0)
    text += fmt::format(" · half the noise: {:.2f} s", stats.seconds.total + 3 * stats.seconds.kernel);
  return text;
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
