// SPDX-License-Identifier: MIT
// closest and anything of intersect.cl for rays that are alike: those of a work-item share their way (accel/packet.h),
// with the same answers.
#include "kernels/intersect.cl"
#include "accel/packet.h"

KERNEL LANE_HINT void closest_packet(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index,
                                     GLOBAL const real* rays, GLOBAL const int* left, GLOBAL real* t, GLOBAL int* found,
                                     ulong count) {
  ulong first = get_global_id(0) * LANES;
  if (first >= count) return;
  Scene scene = scene_of(geometry, shading, index);
  realw planes[RAY_PLANES];
  LANED(rays_given)(&scene, rays + first * RAY_REALS, left + first * LEFT_INTS, planes);
  LANED(NearestEach) hits = LANED(packet_traverse)(&scene, planes, left + first * LEFT_INTS, 0);
  t += first;
  found += first * FOUND_INTS;
  for (int i = 0; i < rays_from(first, count); ++i) {
    t[i] = hits.t[i];
    found[i * FOUND_INTS + FOUND_ID] = hits.id[i];
    found[i * FOUND_INTS + FOUND_KIND] = hits.kind[i];
    found[i * FOUND_INTS + FOUND_SLOT] = hits.slot[i];
    if (HAS_INSTANCES) found[i * FOUND_INTS + FOUND_INSTANCE] = hits.instance[i];
  }
}

KERNEL LANE_HINT void anything_packet(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index,
                                      GLOBAL const real* rays, GLOBAL const int* left, GLOBAL real* t,
                                      GLOBAL int* found, ulong count) {
  ulong first = get_global_id(0) * LANES;
  (void)t;
  if (first >= count) return;
  Scene scene = scene_of(geometry, shading, index);
  realw planes[RAY_PLANES];
  LANED(rays_given)(&scene, rays + first * RAY_REALS, left + first * LEFT_INTS, planes);
  LANED(NearestEach) hits = LANED(packet_traverse)(&scene, planes, left + first * LEFT_INTS, 1);
  for (int i = 0; i < rays_from(first, count); ++i) found[first + (ulong)i] = hits.kind[i] >= 0;
}
