// SPDX-License-Identifier: MIT
// What a picture's file says of how it was made.
#pragma once

#include <map>
#include <string>

#include "cli/commands.h"
#include "cli/render_options.h"
#include "render/renderer.h"

namespace strahl::cli {

/// Of a picture that is still to be rendered.
[[nodiscard]] std::map<std::string, std::string> metadata_of(const RenderOptions& options, const Invocation& invocation,
                                                             const RunStats& stats);
[[nodiscard]] std::map<std::string, std::string> metadata_of(const RenderOptions& options, const Invocation& invocation,
                                                             const RenderResult& result);

/// As "rmse".
[[nodiscard]] std::string rmse_text(const ErrorEstimate& noise);

}  // namespace strahl::cli
