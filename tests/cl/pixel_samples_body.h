// SPDX-License-Identifier: MIT
// Samples of pixels in one tier; needs REAL_BITS and LANES. No guard: once a unit.
#include <cmath>
#include <cstdint>
#include <cstring>

#include "cl/host_features.h"
#include "cl/pixel_samples_tiers.h"
#define HAS_ERROR_SUMS 1
#define HAS_MOMENT 0
#define PATH_LANES LANES

// Internal to the unit: both tiers' headers give their functions the same names.
namespace {
namespace tier {
#include "portable.h"
// OpenCL's, for scene/counters.h.
inline void atomic_inc(uint* counter) { ++*counter; }
inline void atomic_add(uint* counter, uint more) { *counter += more; }
#include "film/span_film.h"
#include "math/vec3.h"
#include "scene/scene.h"
// Lanes come first: they define what the rest is written in.
#include "lanes/lane_ops.h"
// Each needs what is above it.
#include "math/vec3_lanes.h"
// As above.
#include "film/pixel_samples_lanes.h"
}  // namespace tier

tier::SubSums sub_sums(const strahl::test::PixelSums& sums) { return {sums.count, sums.sequences, sums.turn_bits}; }

}  // namespace

namespace strahl::test {

template <>
void add_in_lanes(PixelSums& sums, int first, int place, const std::vector<std::array<tier::real, 3>>& light) {
  const tier::Scene scene{nullptr, nullptr, nullptr, sums.counts.data(), nullptr};
  const int end = first + static_cast<int>(light.size());
  tier::WaitingSamples_w samples;
  // The places before and behind are other pixels'.
  samples.count = tier::POOL_PATHS;
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t i = 0; i < tier::POOL_PATHS; ++i) samples.light[c][i / LANES][i % LANES] = tier::real(1.5);
  for (std::size_t i = 0; i < light.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::size_t at = static_cast<std::size_t>(place) + i;
      samples.light[c][at / LANES][at % LANES] = light[i][c];
    }
  const tier::PixelRun run = tier::run_from_w(&samples, place, first, end);
  tier::add_run_w(&scene, &samples, &run, sub_sums(sums), sums.words.data()->data());
}

template <>
void add_one_by_one(PixelSums& sums, int first, const std::vector<std::array<tier::real, 3>>& light) {
  const tier::Scene scene{nullptr, nullptr, nullptr, sums.counts.data(), nullptr};
  for (std::size_t i = 0; i < light.size(); ++i)
    tier::add_sample(&scene, sums.words.data()->data(), sub_sums(sums), first + static_cast<int>(i),
                     tier::vec3(light[i][0], light[i][1], light[i][2]));
}

}  // namespace strahl::test
