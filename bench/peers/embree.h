// SPDX-License-Identifier: MIT
// Embree (I. Wald et al., "Embree: A Kernel Framework for Efficient CPU Ray Tracing", SIGGRAPH 2014), version 3, where
// it is installed (Debian's libembree-dev): the peer that traversal is measured against.
//
// As fast as it goes: compiled with -O3 -march=native, denormals flushed, the threads take 64 rays at a time; spheres
// and boxes are user geometry with a scalar test inlined into the callback, which beats Embree's own spheres.
#pragma once

#include <memory>

#include "bench/contender.h"

namespace strahl::bench {

struct EmbreeSettings {
  bool robust = false;   ///< RTC_SCENE_FLAG_ROBUST.
  int packet = 1;        ///< rtcIntersect1, 8 or 16; the latter with RTC_INTERSECT_CONTEXT_FLAG_COHERENT.
  bool points = false;   ///< Spheres as RTC_GEOMETRY_TYPE_SPHERE_POINT; packets always have them so.
  unsigned threads = 2;  ///< At least 1.
};

/// Whether strahl-bench was built with it.
[[nodiscard]] bool has_embree();

/// Spheres, planes (within 10^4 of the origin), boxes, triangles, rectangles, cubes and meshes. Throws Error for other
/// shapes, and where Embree is not there.
[[nodiscard]] std::unique_ptr<Contender> embree_contender(const Scene& scene, const EmbreeSettings& settings);

}  // namespace strahl::bench
