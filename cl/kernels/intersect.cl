// SPDX-License-Identifier: MIT
// N rays in, N hits out (core/trace_one.h), LANES rays a work-item: where they hit, or whether; then what is there.
#include "math/vec3.h"
#include "lanes/lane_ops.h"
#include "core/trace_one.h"
#if LANES != 1
#include "accel/packet.h"
#endif

#if LANES != 1
/// find_rays of core/trace_one.h for rays that share their way.
ONCE_FN void LANED(find_packet)(const Scene* scene, GLOBAL const real* in, GLOBAL const int* left, int count,
                                int stop_at_first, GLOBAL real* t, GLOBAL int* found) {
  LANED(Rays) rays;
  LANED(rays_given)(scene, in, left, &rays);
  LANED(NearestEach) hits = LANED(packet_traverse)(scene, &rays, stop_at_first ? FIND_ANY : FIND_NEAREST);
  for (int i = 0; i < count; ++i) {
    Nearest hit = LANED(nearest_of)(&hits, i);
    LANED(store_found)(&hit, i, stop_at_first, t, found);
  }
}
#endif

FN Scene scene_of(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index) {
  Scene scene;
  scene.geometry = geometry;
  scene.shading = shading;
  scene.index = index;
  return scene;
}

/// Where everything is listed, of kinds that ask nothing of rays in common, they are taken in lanes however unlike they
/// are: half of an answer is otherwise what is done for a ray alone.
ONCE_FN void LANED(find)(const Scene* scene, GLOBAL const real* in, GLOBAL const int* left, int count,
                         int stop_at_first, GLOBAL real* t, GLOBAL int* found) {
#if LANES != 1
  int is_any = LANED(PACKET_OF_ANY_RAYS);
  if (is_any) {
    LANED(find_packet)(scene, in, left, count, stop_at_first, t, found);
    return;
  }
#endif
  LANED(find_rays)(scene, in, left, count, stop_at_first, t, found);
}

/// Rays of the block that begins with `first`.
FN int rays_from(ulong first, ulong count) { return count - first < LANES ? (int)(count - first) : LANES; }

KERNEL LANE_HINT void closest(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index,
                              GLOBAL const real* rays, GLOBAL const int* left, GLOBAL real* t, GLOBAL int* found,
                              ulong count) {
  ulong first = get_global_id(0) * LANES;
  if (first >= count) return;
  Scene scene = scene_of(geometry, shading, index);
  LANED(find)
  (&scene, rays + first * RAY_REALS, left + first * LEFT_INTS, rays_from(first, count), 0, t + first,
   found + first * FOUND_INTS);
}

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

/// One work-item a ray.
KERNEL LANE_HINT void describe(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index,
                               GLOBAL const real* rays, GLOBAL const int* left, GLOBAL const real* t,
                               GLOBAL const int* found, GLOBAL real* hits, GLOBAL int* ids, ulong count) {
  ulong i = get_global_id(0);
  if (i >= count) return;
  Scene scene = scene_of(geometry, shading, index);
  ulong lane = i % LANES;
  LANED(describe_one)
  (&scene, rays + (i - lane) * RAY_REALS + lane, left + (i - lane) * LEFT_INTS + lane, t[i], found + i * FOUND_INTS,
   hits + i * HIT_REALS, ids + i * HIT_INTS);
}
