// SPDX-License-Identifier: MIT
// From a file to a validated Scene: Mitsuba 3 XML (docs/scene-format.md), or a bare mesh (.obj, .ply, .serialized).
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "scene/model/scene.h"

namespace strahl {

/// Gets a mesh file that is being read and the share of it that is (MeshProgress).
using LoadProgress = std::function<void(const std::string& file, double share)>;

struct LoadOptions {
  std::map<std::string, std::string> defines;  ///< -D name=value; overrides <default>.
  bool strict = false;                         ///< Unknown plugins and parameters are errors.
  LoadProgress progress = {};
  /// Files outside of this folder are not read; empty: all may be. Of this load alone: those of other threads keep to
  /// roots of their own.
  std::string root = {};
  /// Which <sensor> is the camera: its id, else its number from 0 on in file order. Empty: the first.
  std::string sensor = {};
};

struct LoadedScene {
  Scene scene;
  std::vector<Diagnostic> warnings;  ///< And notes, in file order.
};

/// Throws SceneError with every problem found (never just the first), UsageError where `root` is no folder.
[[nodiscard]] LoadedScene load_scene(const std::string& path, const LoadOptions& options = {});

}  // namespace strahl
