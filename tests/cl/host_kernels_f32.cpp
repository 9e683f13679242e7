// SPDX-License-Identifier: MIT
// The dialect in float, every width. One tier a unit: the headers' guards forbid two.
#include <cmath>
#include <cstdint>
#include <cstring>

#include "cl/host_features.h"
#include "cl/host_kernels.h"

#define REAL_BITS 32
namespace f32 {
#define LANES 1
#include "lanes/lane_ops.h"
// Lanes come first: they define what the bodies are written in.
#include "core/trace_one.h"
#undef LANES
#define LANES 8
#include "lanes/lane_ops.h"
// As above.
#include "core/trace_one.h"
#undef LANES
#define LANES 16
#include "lanes/lane_ops.h"
// As above.
#include "core/trace_one.h"
#undef LANES
}  // namespace f32

namespace strahl::test {

void host_intersect(int lanes, const HostBuffers<float>& scene, const float* rays, const std::int32_t* left,
                    std::size_t count, bool any_hit, float* hits, std::int32_t* ids) {
  const f32::Scene view{scene.geometry, scene.shading, scene.index, nullptr};
  const auto trace = lanes == 16 ? f32::trace_one_16 : lanes == 8 ? f32::trace_one_8 : f32::trace_one_1;
  for (std::size_t i = 0; i < count; ++i)
    trace(&view, rays + i * f32::RAY_REALS, left[i], any_hit, hits + i * f32::HIT_REALS, ids + i * f32::HIT_INTS);
}

}  // namespace strahl::test
