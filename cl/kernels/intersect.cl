// SPDX-License-Identifier: MIT
// N rays in, N hits out (core/trace_one.h), one work-item a ray.
#include "math/vec3.h"
#include "lanes/lane_ops.h"
#include "core/trace_one.h"

KERNEL LANE_HINT void intersect(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index,
                                GLOBAL const real* rays, GLOBAL const int* left, GLOBAL real* hits, GLOBAL int* ids,
                                ulong count, int any_only) {
  ulong i = get_global_id(0);
  if (i >= count) return;
  Scene scene;
  scene.geometry = geometry;
  scene.shading = shading;
  scene.index = index;
  LANED(trace_one)(&scene, rays + i * RAY_REALS, left[i], any_only, hits + i * HIT_REALS, ids + i * HIT_INTS);
}
