// SPDX-License-Identifier: MIT
// The kernels' headers compiled for the host: kernels/intersect.cl as a function, one overload a tier. Every entry of
// every list and every feature is active, so scenes are packed with RenderSettings::generic.
#pragma once

#include <cstddef>
#include <cstdint>

namespace strahl::test {

/// The buffers of cl/scene/layout.h.
template <class Real>
struct HostBuffers {
  const Real* geometry;
  const Real* shading;
  const std::int32_t* index;
};

/// lanes: 1, 8 or 16 in float, 1 or 8 in double; the width that the buffers were packed for. left: DEPARTED_INTS a
/// ray.
void host_intersect(int lanes, const HostBuffers<float>& scene, const float* rays, const std::int32_t* left,
                    std::size_t count, bool any_hit, float* hits, std::int32_t* ids);
void host_intersect(int lanes, const HostBuffers<double>& scene, const double* rays, const std::int32_t* left,
                    std::size_t count, bool any_hit, double* hits, std::int32_t* ids);

}  // namespace strahl::test
