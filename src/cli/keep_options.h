// SPDX-License-Identifier: MIT
// Options that keep what a render has done: checkpoints, parts of the samples, snapshots.
#pragma once

#include <optional>
#include <string>

#include "render/goal.h"

namespace CLI {
class App;
}

namespace strahl::cli {

struct RenderOptions;

struct KeepOptions {
  std::string checkpoint;                     ///< Empty: none is written.
  std::optional<std::string> every;           ///< None: "60s".
  std::string resume;                         ///< Empty: from the start.
  std::optional<std::string> samples;         ///< "a:b"
  std::optional<std::string> watchdog;        ///< None: a launch may take any time.
  std::optional<std::string> snapshot_every;  ///< None: only where SIGUSR1 asks for one.

  /// Where checkpoints go: what is resumed is written on to.
  [[nodiscard]] const std::string& target() const { return checkpoint.empty() ? resume : checkpoint; }
  /// Between checkpoints. Throws UsageError.
  [[nodiscard]] double every_seconds() const;
};

void add_keep_options(CLI::App& app, KeepOptions& options);

/// Throws UsageError for options that contradict each other.
void check_keeping(const RenderOptions& options);

/// Of "64:128": samples 64 to 127. Throws UsageError.
[[nodiscard]] SampleRange sample_range(const std::string& text);

}  // namespace strahl::cli
