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
  const auto trace = [&](auto find, auto any, auto describe) {
    for (std::size_t i = 0; i < count; ++i) {
      const double* ray = rays + i * f64::RAY_REALS;
      double t = 0;
      std::int32_t found[f64::FOUND_INTS] = {-1, -1, -1};
      const bool is_any = any_hit && any(&view, ray, left[i]) != 0;
      if (!any_hit) find(&view, ray, left[i], &t, found);
      describe(&view, ray, left[i], t, found, hits + i * f64::HIT_REALS, ids + i * f64::HIT_INTS);
      if (is_any) hits[i * f64::HIT_REALS + f64::HIT_T] = 0;
    }
  };
  if (lanes == 8)
    trace(f64::find_one_8, f64::is_any_hit_8, f64::describe_one_8);
  else
    trace(f64::find_one_1, f64::is_any_hit_1, f64::describe_one_1);
}

}  // namespace strahl::test
