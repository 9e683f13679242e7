// SPDX-License-Identifier: MIT
// The lines that close a run, for people; for programs there is --stats.
#pragma once

#include <string>

#include "cli/clipping.h"
#include "render/stats.h"

namespace strahl::cli {

/// What the statistics of a run do not know of its picture.
struct Billed {
  std::string picture;  ///< Its file; empty where none was written.
  int width = 0, height = 0;
  bool complete = true;
  bool is_open = false;  ///< Time or error were to end it: no number of samples is the whole.
  int png_bits = 0;      ///< 0 where the file keeps floats.
  Clipping clipping;
};

/// "9.74 s: program 1.20, kernel 8.01, other 0.53": phases that took a hundredth of the time or more.
[[nodiscard]] std::string time_summary(const PhaseSeconds& seconds);

/// Why RunStats::error is none.
[[nodiscard]] std::string why_no_error(const RunStats& stats);

/// What was made, where the time went, how far off it is by cause, what more time would buy: a line each, without a
/// newline at the end.
[[nodiscard]] std::string bill(const RunStats& stats, const Billed& billed);

/// The same in one line: file, seconds, samples, error.
[[nodiscard]] std::string brief_bill(const RunStats& stats, const Billed& billed);

/// Where a picture is not what the scene says: said even with -q.
void warn_of_samples(const UnusualSamples& samples);

/// What -v adds: device, program and whether it came from the cache, launches.
[[nodiscard]] std::string kernel_summary(const RunStats& stats);

}  // namespace strahl::cli
