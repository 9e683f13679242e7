// SPDX-License-Identifier: MIT
// What a device is worth, in less than a minute: rays a second by kind and tier, memory, build times.
#pragma once

#include <functional>
#include <map>

#include "study/bandwidth.h"
#include "study/ray_sets.h"

namespace strahl {

struct DeviceBench {
  std::string device;
  std::string scene;
  std::size_t primitives = 0;
  std::map<std::string, std::size_t> rays;                     ///< By kind.
  std::vector<std::string> tiers;                              ///< Those of the device, as they were measured.
  std::map<std::string, std::map<std::string, double>> mrays;  ///< By kind, then tier: million rays a second.
  std::map<std::string, double> program_seconds;               ///< By tier.
  std::map<std::string, bool> program_from_cache;              ///< By tier: it was loaded, not built, in that time.
  double tree_seconds = 0;
  Bandwidth bandwidth;
};

/// Instances count once each.
[[nodiscard]] std::size_t primitives_of(const Scene& scene);

/// What bench_device and tune (study/tune.h) measure with.
inline constexpr int bench_rounds = 5;
using BenchRays = std::array<RaySet, all_ray_kinds.size()>;  ///< In the order of all_ray_kinds.

/// Every precision that the device has; robust is the third.
[[nodiscard]] std::vector<Precision> tiers_of(const Device& device);
[[nodiscard]] BenchRays bench_rays(Intersector& intersector, const Scene& scene, int side);
/// Warmed up, in turns.
[[nodiscard]] std::vector<double> median_seconds(std::vector<Intersector>& intersectors, const RaySet& set,
                                                 const std::function<void()>& before_round);

/// Called before each of `total` steps.
using BenchProgress = std::function<void(int done, int total)>;

/// Tiers take turns; medians of five rounds. `side`: of the square picture whose rays are traced; 0: what the device
/// answers in an eighth of a second. Throws InputError where no camera ray hits.
[[nodiscard]] DeviceBench bench_device(const Device& device, const Scene& scene, int side = 0,
                                       const BenchProgress& progress = {});

}  // namespace strahl
