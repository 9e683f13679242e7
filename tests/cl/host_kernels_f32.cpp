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
  const auto trace = [&](auto find, auto any, auto describe) {
    for (std::size_t i = 0; i < count; ++i) {
      const float* ray = rays + i * f32::RAY_REALS;
      float t = 0;
      std::int32_t found[f32::FOUND_INTS] = {-1, -1, -1};
      const bool is_any = any_hit && any(&view, ray, left[i]) != 0;
      if (!any_hit) find(&view, ray, left[i], &t, found);
      describe(&view, ray, left[i], t, found, hits + i * f32::HIT_REALS, ids + i * f32::HIT_INTS);
      if (is_any) hits[i * f32::HIT_REALS + f32::HIT_T] = 0;
    }
  };
  if (lanes == 16)
    trace(f32::find_one_16, f32::is_any_hit_16, f32::describe_one_16);
  else if (lanes == 8)
    trace(f32::find_one_8, f32::is_any_hit_8, f32::describe_one_8);
  else
    trace(f32::find_one_1, f32::is_any_hit_1, f32::describe_one_1);
}

}  // namespace strahl::test
