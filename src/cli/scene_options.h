// SPDX-License-Identifier: MIT
// What every subcommand that loads a scene offers: the scene, -D, --sensor, --strict, --root, -q, -v, --no-progress;
// and -d where a device is used.
#pragma once

#include <string>
#include <vector>

#include "scene/model/scene.h"

namespace CLI {
class App;
}

namespace strahl::cli {

struct SceneOptions {
  std::string path;
  std::vector<std::string> defines;  ///< name=value
  bool strict = false;
  std::string sensor;  ///< Id or number; empty: the first.
  std::string root;    ///< Empty: the scene may name any file.
  bool quiet = false;
  bool no_progress = false;
  bool verbose = false;
};

void add_scene_options(CLI::App& app, SceneOptions& options);
/// more: what this command's option can do beside.
void add_device_option(CLI::App& app, std::string& selector, const std::string& more = {});

/// Warnings, and notes where they are asked for.
void say_diagnostics(const std::vector<Diagnostic>& diagnostics, bool with_notes);

/// Loads the scene, with a progress bar for large meshes, and says its warnings on standard error; `seconds` takes the
/// time.
[[nodiscard]] Scene load(const SceneOptions& options, double& seconds);

}  // namespace strahl::cli
