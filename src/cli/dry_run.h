// SPDX-License-Identifier: MIT
// `render --dry-run`: what a render would take and how far off it would be, told from a short pilot.
#pragma once

#include "cli/render_goal.h"

namespace strahl::cli {

/// Prints the prediction on standard output, as JSON with --stats. setup_seconds: of the process so far, the canary and
/// the program included; end_seconds: what writing the picture will take.
[[nodiscard]] ExitCode dry_run(Renderer& renderer, const RenderOptions& options, const Invocation& invocation,
                               int scene_spp, double end_seconds);

}  // namespace strahl::cli
