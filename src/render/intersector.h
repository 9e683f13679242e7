// SPDX-License-Identifier: MIT
// Rays in, hits out: the kernels' intersection as a tool of its own (`strahl intersect`).
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "opencl/device.h"
#include "packing/memory_need.h"
#include "render/stats.h"
#include "scene/model/scene.h"
#include "settings/settings.h"

namespace strahl {

/// World frame; direction of any length > 0; t in units of it; t_min <= t <= t_max counts.
struct Ray {
  Vec3 origin;
  Vec3 direction;
  double t_min = 0;
  double t_max = std::numeric_limits<double>::infinity();
  /// The primitive just left (-1: none): never hit again at the departure point; a quadric's other root is.
  int instance = -1, shape = -1, primitive = -1;
};

/// A miss is t = inf and -1 for the ids.
struct Hit {
  double t = std::numeric_limits<double>::infinity();
  int instance = -1;   ///< -1 where the shape is not instanced.
  int shape = -1;      ///< Index in Scene::shapes; where instance >= 0, in the Group::shapes of its group. As in Ray.
  int primitive = -1;  ///< Within the shape.
  double u = 0, v = 0;
  Vec3 normal;  ///< Unit, as built, not flipped towards the ray.
};

class Intersector {
 public:
  /// Compiles nothing yet. As Renderer's, settings.precision and settings.loop_turns are those of choose_tier()
  /// (trust/tier_choice.h), else rays may miss what they hit. Throws as Renderer does, except KernelBuildError.
  Intersector(const Device& device, const Scene& scene, const RenderSettings& settings = {});
  /// What it takes of the device at the least.
  [[nodiscard]] static MemoryNeed least_memory(const Device& device, const Scene& scene,
                                               const RenderSettings& settings);
  ~Intersector();
  Intersector(Intersector&&) noexcept;
  Intersector& operator=(Intersector&&) noexcept;

  /// any_hit: t is 0 if anything is hit; ids and the rest are those of a miss. It has a program of its own. Each
  /// program is compiled on first use, which counts as stats().seconds.program. `repeat` traces that many times:
  /// stats().seconds.kernel is the median. Throws UsageError for a `repeat` below 1, InputError for a `shape`
  /// or `primitive` that does not exist, and KernelBuildError.
  [[nodiscard]] std::vector<Hit> trace(const std::vector<Ray>& rays, bool any_hit = false, int repeat = 1);
  [[nodiscard]] const RunStats& stats() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace strahl
