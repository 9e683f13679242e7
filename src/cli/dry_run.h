// SPDX-License-Identifier: MIT
// `render --dry-run`: what a render would take and how far off it would be, told from a short pilot.
#pragma once

#include "cli/render_goal.h"
#include "render/pilot.h"

namespace strahl::cli {

/// What is known of a run before its pilot.
struct Preparation {
  double canary_seconds = 0;
  double end_seconds = 0;  ///< What writing the picture and ending the process will take.
  int scene_spp = 1;
};

/// Prints the prediction on standard output, as JSON with --stats.
[[nodiscard]] ExitCode dry_run(Renderer& renderer, const RenderOptions& options, const Invocation& invocation,
                               const Preparation& preparation);

/// Seconds that a pilot may take whose render takes so many: a tenth, or a second where that is more.
[[nodiscard]] double pilot_seconds(double render_seconds);

/// Three lines: seconds, samples, RMSE, each with its interval, or why there is none, and how far to trust them.
[[nodiscard]] std::string prediction_text(const Prediction& prediction, const Pilot& pilot);

}  // namespace strahl::cli
