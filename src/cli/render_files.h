// SPDX-License-Identifier: MIT
// All files of a render, those that come of one option too: a picture a layer, a picture a frame.
#pragma once

#include <string>
#include <vector>

#include "cli/render_options.h"

namespace strahl::cli {

/// "out.0001.png" for "out.png" and 1.
[[nodiscard]] std::string frame_path(const std::string& path, int frame);

/// Throws Error where the files of `frames` frames, each with these layers beside it, could not all be written.
void require_writable_frames(const std::string& picture, int frames, const std::vector<std::string>& layers);

/// Throws UsageError where one of the files would be written over another. picture: empty where none is written;
/// scene_files: that of the options, and those that it names, as far as they are known.
void require_distinct_files(const RenderOptions& options, const std::string& picture,
                            const std::vector<std::string>& scene_files);

}  // namespace strahl::cli
