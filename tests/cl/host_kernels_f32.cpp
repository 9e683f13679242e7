// SPDX-License-Identifier: MIT
// The dialect in float, every width. One tier a unit: the headers' guards forbid two.
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "cl/host_features.h"
#include "cl/host_kernels.h"

#define REAL_BITS 32
namespace f32 {
#define LANES 1
#include "lanes/lane_ops.h"
// Lanes come first: they define what the bodies are written in.
#include "hits/trace_one.h"
#undef LANES
#define LANES 8
#include "lanes/lane_ops.h"
// As above.
#include "hits/trace_one.h"
#undef LANES
#define LANES 16
#include "lanes/lane_ops.h"
// As above.
#include "hits/trace_one.h"
#undef LANES
// They need the bodies.
#include "support/host_rays.h"
}  // namespace f32

namespace strahl::test {

void host_intersect(int lanes, const HostBuffers<float>& scene, const float* rays, const std::int32_t* left,
                    std::size_t count, bool any_hit, float* hits, std::int32_t* ids) {
  const f32::Scene view{scene.geometry, scene.shading, scene.index, nullptr, nullptr};
  const auto trace = [&](auto find, auto describe) {
    f32::host_rays(lanes, view, rays, left, count, any_hit, find, describe, hits, ids);
  };
  if (lanes == 16)
    trace(f32::find_rays_w_16, f32::describe_one_w_16);
  else if (lanes == 8)
    trace(f32::find_rays_w_8, f32::describe_one_w_8);
  else
    trace(f32::find_rays_w_1, f32::describe_one_w_1);
}

}  // namespace strahl::test
