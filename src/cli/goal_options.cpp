// SPDX-License-Identifier: MIT
#include "cli/goal_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>

#include "errors.h"

namespace strahl::cli {

void add_goal_options(CLI::App& app, GoalOptions& options) {
  const std::string group = "When it is done: whatever holds first, --spp included";
  CLI::Option* time = app.add_option("--time", options.time,
                                     "The whole run in so much time, as 16ms, 90s or 10m; with --frames each frame")
                          ->type_name("TIME")
                          ->group(group);
  app.add_option("--max-error", options.max_error, "RMSE over linear RGB no larger than this")
      ->type_name("E")
      ->check(CLI::PositiveNumber.description(""))
      ->group(group);
  CLI::Option* dry_run =
      app.add_flag("--dry-run", options.dry_run, "Predict time and error from a short pilot; write no picture")
          ->group(group);
  app.add_option("--frames", options.frames, "Render so many pictures, seeds one after the other; needs --time")
      ->type_name("N")
      ->check(CLI::Range(1, 1000000).description(""))
      ->needs(time)
      ->excludes(dry_run)
      ->group(group);
}

double duration_seconds(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  const std::string unit(rest, end);
  const double scale = unit == "ms"                   ? 1e-3
                       : unit.empty() || unit == "s"  ? 1
                       : unit == "m" || unit == "min" ? 60
                       : unit == "h"                  ? 3600
                                                      : 0;
  if (error != std::errc() || scale == 0 || !(value > 0) || !std::isfinite(value))
    throw UsageError(fmt::format("\"{}\" is no time; 16ms, 90s, 10m and 1.5h are", text));
  return value * scale;
}

}  // namespace strahl::cli
