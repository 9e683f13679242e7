// SPDX-License-Identifier: MIT
// `render --frames N --time 16ms`: scene, program and buffers are there, and the clock starts anew for each picture.
#pragma once

#include "cli/commands.h"
#include "cli/interrupt.h"
#include "cli/render_options.h"
#include "render/renderer.h"

namespace strahl::cli {

/// Frame i has the seed i after the scene's. Its time covers sampling and making the picture, not writing its file
/// ("out.0001.png"), for which the clock stands still. One frame in twenty may be late. Of an interrupted
/// frame the samples so far are written, with "incomplete" in its text; no summary counts it.
[[nodiscard]] ExitCode render_frames(Renderer& renderer, const RenderOptions& options, const Invocation& invocation,
                                     const PictureFiles& files, std::uint32_t first_seed, const InterruptGuard& guard);

}  // namespace strahl::cli
