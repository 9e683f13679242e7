// SPDX-License-Identifier: MIT
// Options that say how a scene is computed: precision, lanes, work-groups, passes, AOVs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "settings/settings.h"

namespace CLI {
class App;
}

namespace strahl::cli {

struct KernelOptions {
  std::optional<std::string> precision;  ///< None: robust, or what the device can do instead.
  bool no_canary = false;
  std::optional<int> lanes;
  std::optional<int> bvh_width;
  std::optional<std::string> paths;
  std::string acceleration;  ///< "auto", "list" or "tree"; empty: auto.
  std::string work_group;    ///< "8x8", "64"; empty: the default.
  std::optional<int> passes;
  std::optional<std::string> memory_limit;  ///< "512M"
  std::vector<std::string> disabled;
  bool generic = false;
  bool no_error = false;
  bool texture_lod = false;
  std::optional<std::string> light_choice;
  std::vector<std::string> aovs;

  /// --aov has it.
  [[nodiscard]] bool asks_for(std::string_view aov) const { return std::ranges::find(aovs, aov) != aovs.end(); }
};

/// --precision, --lanes, --bvh-width and --accel: what every kernel has.
void add_kernel_options(CLI::App& app, KernelOptions& options);
/// --no-canary: what everything has that computes.
void add_canary_option(CLI::App& app, KernelOptions& options);
/// --aov and --generic: what decides the rendering program beside the scene.
void add_program_options(CLI::App& app, KernelOptions& options);
/// --work-group and --passes: how a render is launched.
void add_launch_options(CLI::App& app, KernelOptions& options);

/// Bytes of "512M", "2G", "512MiB", "1500000k" or a plain number, in powers of 1024; none where nothing is asked for.
/// Throws UsageError.
[[nodiscard]] std::optional<std::uint64_t> memory_limit(const KernelOptions& options);

/// Throws UsageError.
[[nodiscard]] RenderSettings settings_of(const KernelOptions& options);

}  // namespace strahl::cli
