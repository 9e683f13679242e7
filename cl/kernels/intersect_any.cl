// SPDX-License-Identifier: MIT
// Whether rays hit anything.
#include "kernels/find_lanes.h"

/// found: 1 or 0 a ray. t is not touched.
KERNEL LANE_HINT void anything(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index,
                               GLOBAL const real* rays, GLOBAL const int* left, GLOBAL real* t, GLOBAL int* found,
                               ulong count) {
  ulong first = get_global_id(0) * LANES;
  if (first >= count) return;
  Scene scene = scene_of(geometry, shading, index);
  LANED(find)
  (&scene, rays + first * RAY_REALS, left + first * LEFT_INTS, rays_from(first, count), 1, t + first, found + first);
}
