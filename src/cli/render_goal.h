// SPDX-License-Identifier: MIT
// From the options --time, --max-error and --spp to a goal of the renderer, and whether it was reached.
#pragma once

#include <optional>
#include <string>

#include "cli/commands.h"
#include "cli/render_options.h"
#include "render/renderer.h"

namespace strahl::cli {

/// Throws UsageError for options that contradict each other.
void check_goal(const RenderOptions& options);

/// Throws UsageError where the scene's number of samples, or that of the part, tells no error, and --error-map asks for
/// one.
void require_map_samples(const RenderOptions& options, const Scene& scene);

/// end_seconds: what writing the picture and ending the process will take. The deadline counts from the start of the
/// process.
[[nodiscard]] RenderGoal goal_of(const RenderOptions& options, const Invocation& invocation, double end_seconds);

/// Why a goal was missed, with the remedy; none where it was reached.
[[nodiscard]] std::optional<std::string> missed_goal(const RenderOptions& options, const RenderResult& result);

/// Later than this is late: a fiftieth, or 20 ms where that is more.
[[nodiscard]] double latest_seconds(double time);

}  // namespace strahl::cli
