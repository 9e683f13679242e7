// SPDX-License-Identifier: MIT
// The dialect in double, widths 1 and 8. One tier a unit: the headers' guards forbid two.
#include <cmath>
#include <cstdint>
#include <cstring>

#include "cl/host_features.h"
#include "cl/host_kernels.h"

#define REAL_BITS 64
namespace f64 {
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
}  // namespace f64

namespace strahl::test {

void host_intersect(int lanes, const HostBuffers<double>& scene, const double* rays, const std::int32_t* left,
                    std::size_t count, bool any_hit, double* hits, std::int32_t* ids) {
  const f64::Scene view{scene.geometry, scene.shading, scene.index, nullptr};
  const auto trace = lanes == 8 ? f64::trace_one_8 : f64::trace_one_1;
  for (std::size_t i = 0; i < count; ++i)
    trace(&view, rays + i * f64::RAY_REALS, left[i], any_hit, hits + i * f64::HIT_REALS, ids + i * f64::HIT_INTS);
}

}  // namespace strahl::test
