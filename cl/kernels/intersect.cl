// SPDX-License-Identifier: MIT
// N rays in, N hits out: first where the rays hit, then the surfaces there.
#define STOP_AT_FIRST 0
#include "kernels/find_lanes.h"
#include "hits/describe_lanes.h"

/// LANES rays a work-item. hits, ids: blocks of HIT_REALS and HIT_INTS planes.
KERNEL LANE_HINT void describe(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index,
                               GLOBAL const real* rays, GLOBAL const int* departed, GLOBAL const real* t,
                               GLOBAL const int* found, GLOBAL real* hits, GLOBAL int* ids, ulong count) {
  ulong first = get_global_id(0) * LANES;
  if (first >= count) return;
  Scene scene = scene_of(geometry, shading, index, (GLOBAL uint*)0);
  describe_w(&scene, rays + first * RAY_REALS, departed + first * DEPARTED_INTS, rays_there_w(first, count), t + first,
             found + first * FOUND_INTS, hits + first * HIT_REALS, ids + first * HIT_INTS);
}
