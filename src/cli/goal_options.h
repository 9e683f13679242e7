// SPDX-License-Identifier: MIT
// Options that say when a picture is done: time, error, frames.
#pragma once

#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace strahl::cli {

struct GoalOptions {
  std::optional<std::string> time;  ///< "16ms", "2.5" (seconds), "90s", "10m", "1.5h"
  std::optional<double> max_error;
  std::optional<int> frames;
  bool dry_run = false;
};

void add_goal_options(CLI::App& app, GoalOptions& options);

/// Seconds of "16ms", "90s", "10m", "1.5h" or "2.5" (seconds). Throws UsageError, which names the option.
[[nodiscard]] double duration_seconds(const std::string& text, const char* option = "--time");

}  // namespace strahl::cli
