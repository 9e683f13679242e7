// SPDX-License-Identifier: MIT
// N rays in, N hits out: first where the rays hit, then the surfaces there.
#define STOP_AT_FIRST 0
#include "kernels/find_lanes.h"

/// One work-item a ray.
KERNEL LANE_HINT void describe(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index,
                               GLOBAL const real* rays, GLOBAL const int* departed, GLOBAL const real* t,
                               GLOBAL const int* found, GLOBAL real* hits, GLOBAL int* ids, ulong count) {
  ulong i = get_global_id(0);
  if (i >= count) return;
  Scene scene = scene_of(geometry, shading, index, (GLOBAL uint*)0);
  ulong lane = i % LANES;
  describe_one_w(&scene, rays + (i - lane) * RAY_REALS + lane, departed + (i - lane) * DEPARTED_INTS + lane, t[i],
                 found + i * FOUND_INTS, hits + i * HIT_REALS, ids + i * HIT_INTS);
}
