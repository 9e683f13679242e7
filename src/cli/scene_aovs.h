// SPDX-License-Identifier: MIT
// What becomes of the AOVs that a scene names: layers of an EXR file, and of a checkpoint, which may become one.
#pragma once

#include <string>
#include <vector>

#include "cli/render_options.h"
#include "scene/model/scene.h"
#include "settings/aov_list.h"

namespace strahl::cli {

/// Adds the scene's to those of --aov where `picture` (empty: none is written) or a checkpoint can hold them, and says
/// where they are not written: in files of other formats, and by integrators without a camera ray in every pixel.
/// Throws UsageError where --aov has a channel of the same name and another value.
void add_scene_aovs(const Scene& scene, const RenderOptions& options, const std::string& picture, AovList& aovs);

/// Says that the picture of --samples has no layers of first samples, where it begins behind them.
void warn_of_later_samples(const KeepOptions& keep, const AovList& aovs);

/// Says which ids a file of floats rounds: of shapes, or of primitives in a shape, of more than 2^24.
void warn_of_rounded_ids(const Scene& scene, const AovList& aovs);

/// What is said where `picture` is no EXR file and so lacks these.
void say_unwritten(const std::vector<NamedAov>& aovs, const std::string& picture);

}  // namespace strahl::cli
