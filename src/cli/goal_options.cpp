// SPDX-License-Identifier: MIT
#include "cli/goal_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <string_view>

#include "cli/number_options.h"
#include "errors.h"
#include "scene/xml/parse_value.h"

namespace strahl::cli {

void add_goal_options(CLI::App& app, GoalOptions& options) {
  const std::string group = "When it is done: whatever holds first, --spp included";
  CLI::Option* time =
      app.add_option(
             "--time", options.time,
             "The whole run in so much time, as 16ms, 2.5 or 90s (seconds), 10m, 1.5h; with --frames each frame")
          ->type_name("TIME")
          ->group(group);
  require_positive(app.add_option("--max-error", options.max_error, "RMSE over linear RGB no larger than this"))
      ->type_name("E")
      ->group(group);
  CLI::Option* dry_run =
      app.add_flag("--dry-run", options.dry_run, "Predict time and error from a short pilot; write no picture")
          ->group(group);
  require_whole(
      app.add_option("--frames", options.frames, "Render so many pictures, seeds one after the other; needs --time"))
      ->type_name("N")
      ->check(CLI::Range(1, 1000000).description(""))
      ->needs(time)
      ->excludes(dry_run)
      ->group(group);
}

double duration_seconds(const std::string& text, const char* option) {
  const std::size_t number_end = std::min(text.find_first_not_of("0123456789.eE+-"), text.size());
  const std::optional<double> value = parse_number(std::string_view(text).substr(0, number_end));
  const std::string unit = text.substr(number_end);
  const double scale = unit == "ms"                   ? 1e-3
                       : unit.empty() || unit == "s"  ? 1
                       : unit == "m" || unit == "min" ? 60
                       : unit == "h"                  ? 3600
                                                      : 0;
  const double seconds = value.value_or(0) * scale;
  if (!(seconds > 0) || !std::isfinite(seconds))
    throw UsageError(fmt::format(
        "{}: must be a finite time > 0, as 16ms, 2.5 or 90s (seconds), 10m or 1.5h, not \"{}\"", option, text));
  return seconds;
}

}  // namespace strahl::cli
