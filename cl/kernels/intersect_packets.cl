// SPDX-License-Identifier: MIT
// closest and anything of intersect.cl for rays that are alike: those of a work-item share their way (accel/packet.h),
// with the same answers.
#include "kernels/intersect.cl"

KERNEL LANE_HINT void closest_packet(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index,
                                     GLOBAL const real* rays, GLOBAL const int* left, GLOBAL real* t, GLOBAL int* found,
                                     ulong count) {
  ulong first = get_global_id(0) * LANES;
  if (first >= count) return;
  Scene scene = scene_of(geometry, shading, index);
  LANED(find_packet)
  (&scene, rays + first * RAY_REALS, left + first * LEFT_INTS, rays_from(first, count), 0, t + first,
   found + first * FOUND_INTS);
}

KERNEL LANE_HINT void anything_packet(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index,
                                      GLOBAL const real* rays, GLOBAL const int* left, GLOBAL real* t,
                                      GLOBAL int* found, ulong count) {
  ulong first = get_global_id(0) * LANES;
  if (first >= count) return;
  Scene scene = scene_of(geometry, shading, index);
  LANED(find_packet)
  (&scene, rays + first * RAY_REALS, left + first * LEFT_INTS, rays_from(first, count), 1, t + first, found + first);
}
