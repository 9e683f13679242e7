// SPDX-License-Identifier: MIT
// The time and memory that a run used, as --stats writes them (docs/stats.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "packing/tree_stats.h"
#include "render/error_budget.h"
#include "render/unusual_samples.h"

namespace strahl {

/// Wall seconds per phase. `other` is total minus the rest.
struct PhaseSeconds {
  double load = 0, bvh = 0, program = 0, upload = 0, kernel = 0, readback = 0, encode = 0, total = 0;
  double surface = 0;  ///< Of `intersect`: normal, u and v of the hits found, once however often rays were traced.
  double start = 0;    ///< From the process's start to main.
  double exit = 0;     ///< Expected, from the last line to the end of the process.
  double device = 0;   ///< Finding and opening it.
  double error = 0;    ///< Estimating it from the film.
  [[nodiscard]] double other() const {
    return total - start - exit - device - load - bvh - program - upload - kernel - surface - readback - error - encode;
  }
};

/// The canary's result (trust/canary.h) for the precision in use.
struct CanaryStats {
  std::string verdict;  ///< "holds" or "degraded".
  std::string why;      ///< Empty where it holds.
  std::string instead;  ///< Why it stands in for the default; empty where it does not.
};

/// What one device of several has done.
struct DeviceShare {
  std::string device;
  std::uint64_t samples = 0;  ///< Of pixels, in the film.
  double seconds = 0;         ///< It was at work.
  std::string fault;          ///< Why it was dropped; empty: it was not.
};

struct RunStats {
  PhaseSeconds seconds;
  /// Seconds of each launch (render; the first most_kept_runs) or each repetition (intersect).
  std::vector<double> kernel_runs;
  std::uint64_t more_runs = 0;  ///< Launches beyond: a render of days would keep millions of numbers.
  double longest_of_more = 0;
  std::uint64_t camera_rays = 0;
  std::uint64_t resumed_samples = 0;         ///< Of all pixels, that the run went on from; not among the camera rays.
  std::optional<std::uint64_t> shadow_rays;  ///< Only the instrumented program counts these.
  std::optional<std::uint64_t> bounce_rays;
  std::optional<std::uint64_t> nodes_visited;  ///< By all rays together, as `primitives_tested`.
  std::optional<std::uint64_t> primitives_tested;
  std::uint64_t device_bytes = 0;  ///< Allocated in device buffers at the most.
  std::uint64_t scene_bytes = 0;   ///< Of them, the packed scene's.
  std::uint64_t host_bytes = 0;    ///< Packed scene plus film on the host.
  std::string device;
  std::vector<DeviceShare> shares;  ///< Of each device, where there are several.
  std::string precision;
  std::optional<CanaryStats> canary;  ///< None: it was not asked.
  int spp = 0;  ///< Asked for; where a deadline or an error was the goal, the most that a pixel got.
  int least_spp = 0, most_spp = 0;  ///< Of all pixels.
  std::uint32_t seed = 0;
  std::vector<std::string> features;  ///< "shapes/sphere", "AOV", ...: those that are on.
  bool texture_lod = false;           ///< Images are filtered: a bias that `error` does not hold.
  std::vector<std::string> disabled;  ///< As asked for: RenderSettings::disabled.
  int lanes = 1;
  int path_lanes = 1;
  int tree_width = 4;
  TreeStats tree;
  bool program_from_cache = false;
  std::uint64_t program_bytes = 0;       ///< Of its binary.
  std::uint64_t private_bytes = 0;       ///< Of a work-item, as the driver tells it: PoCL says 1024 of any kernel.
  std::string program;                   ///< Hash, as `explain` prints it.
  std::optional<ErrorBudget> error;      ///< None: not measured.
  std::optional<double> clipped_pixels;  ///< Share of the pixels brighter than the file's white; none: it has no white.
  std::string ending;                    ///< ending_name of what ended the render.
  UnusualSamples unusual;

  static constexpr std::size_t most_kept_runs = 1024;
  void add_launch(double run_seconds);
  /// Those of a part of the picture.
  void add_launches(const RunStats& part);
  [[nodiscard]] std::uint64_t launches() const { return kernel_runs.size() + more_runs; }
  [[nodiscard]] double longest_launch() const;
  /// The documented JSON object, pretty-printed.
  [[nodiscard]] std::string json() const;
};

}  // namespace strahl
