// SPDX-License-Identifier: MIT
// Everything that `strahl render` was told.
#pragma once

#include <string>

#include "cli/goal_options.h"
#include "cli/keep_options.h"
#include "cli/kernel_options.h"
#include "cli/picture_files.h"
#include "cli/scene_options.h"
#include "cli/scene_overrides.h"

namespace strahl::cli {

struct RenderOptions {
  SceneOptions scene;
  SceneOverrides overrides;
  KernelOptions kernel;
  GoalOptions goal;
  KeepOptions keep;
  std::string device;
  std::string output;
  std::string error_map;
  PngOptions png;
  std::string stats;
  bool stats_detail = false;
  bool brief = false;
  std::string dump_kernel;

  /// Else numbers or samples alone are asked for.
  [[nodiscard]] bool writes_picture() const { return !output.empty() || !(overrides.pixel || keep.samples); }
};

}  // namespace strahl::cli
