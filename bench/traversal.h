// SPDX-License-Identifier: MIT
// What traversal is worth: scene x kind of rays x tier x width against the peers that are there.
#pragma once

#include <functional>

#include "bench/race.h"
#include "opencl/device.h"

namespace strahl::bench {

struct TraversalOptions {
  std::vector<std::string> scenes{"ten", "sphereflake-5", "terrain-1000000"};  ///< Generated, or files.
  std::vector<RayKind> kinds{all_ray_kinds.begin(), all_ray_kinds.end()};
  std::vector<Precision> tiers;  ///< Empty: all that the device has.
  std::vector<int> widths;       ///< Of the tree; empty: the device's own.
  bool peers = true;
  int pixels = 1024;  ///< Of a generated scene's side: as many squared primary rays.
  int rounds = 9;
  unsigned threads = 0;  ///< Of the peers; 0: as many as the machine has.
};

/// A tree, as built over a scene by one program.
struct Tree {
  std::string scene;
  std::size_t primitives = 0;
  std::string program;
  std::vector<double> seconds;  ///< A round each.
  double sah_cost = 0;
};

/// Everything that one call measured, for the report and for JSON.
struct Traversal {
  std::string device;
  std::string machine;
  std::string version;
  unsigned threads = 0;  ///< Of the peers.
  int rounds = 0;
  std::vector<Race> races;
  std::vector<Tree> trees;
};

/// A scene by the name of generated_scene or, where there is a dot or a slash in it, from a file, whose warnings `say`
/// hears.
[[nodiscard]] Scene bench_scene(const std::string& name, const std::function<void(const std::string&)>& say);

/// `say` hears what goes on: a line a race.
[[nodiscard]] Traversal measure_traversal(const Device& device, const TraversalOptions& options,
                                          const std::function<void(const std::string&)>& say);

/// bench/README.md states the members.
[[nodiscard]] std::string json(const Traversal& traversal);
[[nodiscard]] Traversal traversal_of_json(const std::string& text);
/// Of several such files, in their order. Throws InputError where they are of different devices or machines.
[[nodiscard]] Traversal traversal_of_files(const std::vector<std::string>& paths);

}  // namespace strahl::bench
