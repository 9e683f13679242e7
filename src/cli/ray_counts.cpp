// SPDX-License-Identifier: MIT
#include "cli/ray_counts.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "cli/console.h"
#include "cli/keep_options.h"
#include "cli/progress_bar.h"
#include "render/renderer.h"

namespace strahl::cli {
namespace {

/// Renders the same samples again with the instrumented program and takes only its counts, so that counting costs the
/// timed one nothing: where time or error ended the run, as many in all pixels as it had in one. Rays that go through
/// the scene together cannot say what each of them visits, so that each goes by itself.
nlohmann::ordered_json count(const Device& device, const Scene& scene, RenderSettings settings, const RenderOptions& o,
                             const InterruptGuard& guard, RunStats& stats) {
  RenderGoal goal;
  goal.spp = o.overrides.spp;
  if (o.keep.samples) goal.samples = sample_range(*o.keep.samples);
  settings.count_rays = true;
  settings.paths_in_lanes = false;
  settings.passes.reset();  // Launches are short then: what one counts is told in 32 bits.
  settings.acceleration = stats.tree.nodes > 0 ? Acceleration::tree : Acceleration::list;
  Renderer renderer(device, scene, settings);
  if (o.goal.time || o.goal.max_error) {  // Some of more: how many there may be decides which numbers each one draws.
    goal.spp = o.overrides.spp.value_or(renderer.most_samples());
    goal.samples = SampleRange{0, stats.most_spp};
  }
  ProgressBar bar("count", !o.scene.quiet && !o.scene.no_progress);
  const RenderResult counted = renderer.render(
      [&](const Progress& progress) {
        bar.show(progress);
        return !guard.interrupted();
      },
      goal);
  if (!counted.complete) return nullptr;
  stats.shadow_rays = counted.stats.shadow_rays;
  stats.bounce_rays = counted.stats.bounce_rays;
  stats.nodes_visited = counted.stats.nodes_visited;
  stats.primitives_tested = counted.stats.primitives_tested;
  return {{"program", counted.stats.program}, {"kernel", counted.stats.seconds.kernel}};
}

}  // namespace

nlohmann::ordered_json count_if_possible(const SharedDevice& on, const Scene& scene, const RenderOptions& options,
                                         const InterruptGuard& guard, RunStats& stats) try {
  return count(on.device, scene, on.settings, options, guard, stats);
} catch (const std::exception& fault) {
  say(fmt::format("strahl: warning: --stats-detail counts nothing: {}", fault.what()));
  return nullptr;
}

}  // namespace strahl::cli
