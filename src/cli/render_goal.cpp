// SPDX-License-Identifier: MIT
#include "cli/render_goal.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/summary.h"
#include "packing/cl_layout.h"
#include "render/pass_plan.h"
#include "settings/sampling.h"

namespace strahl::cli {
double latest_seconds(double time) { return time + std::max(0.02 * time, 0.02); }

void check_goal(const RenderOptions& options) {
  const GoalOptions& goal = options.goal;
  if (options.kernel.no_error && (goal.max_error || !options.error_map.empty() || goal.dry_run))
    throw UsageError("--no-error: then there is no error for --max-error, --error-map or --dry-run to tell");
  if ((goal.time || goal.max_error) && options.kernel.passes)
    throw UsageError("--passes splits a number of samples that is known; with --time or --max-error it is not");
  if (goal.frames && options.overrides.pixel) throw UsageError("--frames writes pictures, --pixel prints one value");
  if (goal.frames && !options.error_map.empty()) throw UsageError("--frames writes pictures, --error-map tells of one");
  if (goal.frames && options.stats_detail) throw UsageError("--frames counts no rays, as --stats-detail asks for");
  if (goal.dry_run && (options.stats_detail || !options.error_map.empty()))
    throw UsageError("--dry-run makes no picture: there is nothing for --stats-detail to count, or for --error-map");
  if (goal.time && options.kernel.asks_for("numeric_error"))
    throw UsageError(
        "--aov numeric_error traces the scene once more after the last sample, by a program that may have to be built, "
        "and --time leaves no time for it; state --spp or --max-error instead");
  if (goal.time) static_cast<void>(duration_seconds(*goal.time));
  check_keeping(options);
}

void require_map_samples(const RenderOptions& options, const Scene& scene) {
  // With a time or an error as the goal the scene's own number does not count.
  const GoalOptions& goal = options.goal;
  if (options.error_map.empty() || ((goal.time || goal.max_error) && !options.overrides.spp)) return;
  const bool is_part = options.keep.samples.has_value();
  const int count = is_part ? sample_range(*options.keep.samples).count : resolve_sampling(scene).spp;
  if (count < layout::FILM_SUBSUMS)
    throw UsageError(fmt::format("--error-map: the error is told from {} samples a pixel or more, not from {}; {}",
                                 int{layout::FILM_SUBSUMS}, count,
                                 is_part ? "take more of them with --samples" : "state --spp"));
}

RenderGoal goal_of(const RenderOptions& options, const Invocation& invocation, double end_seconds) {
  RenderGoal goal;
  goal.spp = options.overrides.spp;
  if (options.keep.samples) goal.samples = sample_range(*options.keep.samples);
  goal.max_error = options.goal.max_error;
  if (options.goal.time) {
    const double seconds = duration_seconds(*options.goal.time) - end_seconds;
    goal.deadline = later(invocation.start, seconds);
  }
  return goal;
}

std::optional<std::string> missed_goal(const RenderOptions& options, const RenderResult& result) {
  const RunStats& stats = result.stats;
  const PhaseSeconds& s = stats.seconds;
  if (options.goal.time) {
    const double pixels = static_cast<double>(result.color.width) * result.color.height;
    const double sample = stats.camera_rays > 0 ? s.kernel / static_cast<double>(stats.camera_rays) * pixels : 0;
    if (stats.least_spp == 0)
      return fmt::format("--time {}: some pixels have no sample and are black; at least {:.2f} s would be needed",
                         *options.goal.time, s.total - s.kernel + 1.1 * sample);
    if (s.total > latest_seconds(duration_seconds(*options.goal.time)))
      return fmt::format("--time {}: finished after {:.3f} s; at least {:.2f} s are needed", *options.goal.time,
                         s.total, s.total - s.kernel + 1.1 * sample);
  }
  if (!options.goal.max_error) return std::nullopt;
  // Whatever ended it, between two looks or before the first one: the picture that there is counts.
  if (!stats.error) return fmt::format("--max-error {}: not known, {}", *options.goal.max_error, why_no_error(stats));
  if (!is_reached(stats.error->noise, *options.goal.max_error))
    return fmt::format("--max-error {}: {:.2g} (95 %: up to {:.2g}) when the {} ended it", *options.goal.max_error,
                       stats.error->noise.rmse, stats.error->noise.rmse_high,
                       result.ending == Ending::deadline ? "time" : "number of samples");
  return std::nullopt;
}

}  // namespace strahl::cli
