// SPDX-License-Identifier: MIT
#include "cli/summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "cli/console.h"
#include "packing/cl_layout.h"

namespace strahl::cli {

std::string why_no_error(const RunStats& stats) {
  if (stats.unusual.not_finite() > 0) return "samples were not finite, see the warning";
  return "a pixel has fewer than 4 samples, or --no-error";
}

namespace {

/// Phases that took less than this share of the time are billed together.
constexpr double small_phase = 0.01;

std::string rounding_text(const ErrorBudget& error) {
  const std::optional<double>& rounding = error.rounding;
  if (!rounding) return fmt::format("not measured ({})", error.unmeasured);
  return *rounding < 1e-6 ? "< 1e-6" : fmt::format("{:.2g}", *rounding);
}

/// Of this run, and with those that it went on from.
double new_samples(const RunStats& stats) { return std::max(1.0, static_cast<double>(stats.camera_rays)); }
double all_samples(const RunStats& stats) { return new_samples(stats) + static_cast<double>(stats.resumed_samples); }

std::string error_line(const RunStats& stats, int png_bits) {
  if (!stats.error) return "  error    not measured: " + why_no_error(stats);
  const ErrorBudget& error = *stats.error;
  std::string text = fmt::format("  error    RMSE {:.2g} (95 %: {:.2g} to {:.2g}): noise {:.2g}", error.rmse(),
                                 error.rmse_low(), error.rmse_high(), error.noise.rmse);
  if (png_bits > 0) text += fmt::format(", {}-bit output {:.2g}", png_bits, error.output);
  text += ", float rounding " + rounding_text(error);
  // Independent samples need four times as many; scrambled sequences at the most.
  if (error.noise.rmse > 0)
    text += fmt::format("\n           half the noise: {:.2f} s at the most",
                        stats.seconds.total + 3 * stats.seconds.kernel * all_samples(stats) / new_samples(stats));
  return text;
}

std::string samples_text(const RunStats& stats, const Billed& billed) {
  const bool is_told_by_pixels = billed.complete || billed.is_open;
  return stats.least_spp == stats.most_spp || !is_told_by_pixels
             ? std::to_string(stats.spp)
             : fmt::format("{} to {}", stats.least_spp, stats.most_spp);
}

std::string interrupted_text(const RunStats& stats, const Billed& billed) {
  if (billed.complete) return {};
  if (billed.is_open) return " · interrupted";
  const double samples = static_cast<double>(billed.width) * billed.height * stats.spp;
  return fmt::format(" · interrupted after {:.0f} % of the samples",
                     100 * static_cast<double>(stats.camera_rays + stats.resumed_samples) / samples);
}

}  // namespace

std::string time_summary(const PhaseSeconds& s) {
  const std::array<std::pair<const char*, double>, 12> phases{{{"start", s.start},
                                                               {"device", s.device},
                                                               {"load", s.load},
                                                               {"bvh", s.bvh},
                                                               {"program", s.program},
                                                               {"upload", s.upload},
                                                               {"kernel", s.kernel},
                                                               {"surface", s.surface},
                                                               {"readback", s.readback},
                                                               {"error", s.error},
                                                               {"encode", s.encode},
                                                               {"exit", s.exit}}};
  std::string text = fmt::format("{:.2f} s: ", s.total);
  double rest = s.total;
  for (const auto& [name, seconds] : phases) {
    if (seconds < small_phase * s.total || seconds == 0) continue;
    text += fmt::format("{} {:.2f}, ", name, seconds);
    rest -= seconds;
  }
  return text + fmt::format("other {:.2f}", std::max(0.0, rest));
}

std::string bill(const RunStats& stats, const Billed& billed) {
  std::string text =
      fmt::format("{}{}×{} · {} spp · {}{}\n  time     {}\n{}", billed.picture.empty() ? "" : billed.picture + " ",
                  billed.width, billed.height, samples_text(stats, billed), stats.device,
                  interrupted_text(stats, billed), time_summary(stats.seconds), error_line(stats, billed.png_bits));
  if (stats.texture_lod)
    text += "\n  textures filtered to the pixel's width (--texture-lod), a blur that the error does not tell";
  if (const std::string clipping = clipping_text(billed.clipping); !clipping.empty())
    text += "\n  clipped  " + clipping;
  return text;
}

std::string brief_bill(const RunStats& stats, const Billed& billed) {
  std::string text = fmt::format("{}{:.2f} s · {} spp", billed.picture.empty() ? "" : billed.picture + " · ",
                                 stats.seconds.total, samples_text(stats, billed));
  if (stats.error)
    text += fmt::format(" · RMSE {:.2g} ({:.2g} to {:.2g})", stats.error->rmse(), stats.error->rmse_low(),
                        stats.error->rmse_high());
  return text + interrupted_text(stats, billed);
}

std::string kernel_summary(const RunStats& stats) {
  return fmt::format(
      "device {}\nprogram {} ({}; {}, {} lane{}), {}\nlaunches {}, the longest {:.4f} s; {:.1f} MiB on the device, "
      "{:.1f} MiB on the host",
      stats.device, stats.program, stats.program_from_cache ? "from the cache" : "built", stats.precision, stats.lanes,
      stats.lanes == 1 ? "" : "s", fmt::join(stats.features, " "), stats.launches(), stats.longest_launch(),
      static_cast<double>(stats.device_bytes) / (1 << 20), static_cast<double>(stats.host_bytes) / (1 << 20));
}

void warn_of_samples(const UnusualSamples& samples) {
  if (samples.saturated > 0)
    say(fmt::format("strahl: warning: {} sample channels were beyond the largest float; they count as 3.4e38",
                    samples.saturated));
  if (samples.lost_branches > 0)
    say(fmt::format(
        "strahl: warning: {} rays of whitted were not followed beside stronger ones: their samples had been at {} "
        "mirrors and surfaces of glass; max_depth limits them, and --integrator path follows one way of two",
        samples.lost_branches, static_cast<int>(layout::WHITTED_MOST_RAYS)));
  if (samples.lost_interfaces > 0)
    say(fmt::format(
        "strahl: warning: {} times a ray was within more than 8 shapes of glass that have a priority; what it "
        "entered then was taken for air on the way out",
        samples.lost_interfaces));
  if (samples.invalid > 0)
    say(fmt::format("strahl: warning: {} sample channels were not a number; they count as black", samples.invalid));
}

}  // namespace strahl::cli
