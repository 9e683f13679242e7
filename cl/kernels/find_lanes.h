// SPDX-License-Identifier: MIT
// The kernel that finds, LANES rays a work-item (core/trace_one.h): where they hit or, with STOP_AT_FIRST 1, whether.
// Each question is a program of its own, for a walk is most of what a program compiles and few callers ask both. One
// width; no guard.
#include "math/vec3.h"
#include "lanes/lane_ops.h"
#include "core/trace_one.h"
#include "core/whole_loops.h"
#if LANES != 1
#include "accel/packet.h"
#endif

/// 1: the rays of a work-item are expected to be alike, and share their way (accel/packet.h); the answers are the same.
#ifndef RAYS_ARE_ALIKE
#define RAYS_ARE_ALIKE 0
#endif

FN Scene scene_of(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index) {
  Scene scene;
  scene.geometry = geometry;
  scene.shading = shading;
  scene.index = index;
  return scene;
}

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

/// Where everything is listed, of kinds that ask nothing of rays in common, they are taken in lanes however unlike they
/// are: half of an answer is otherwise what is done for a ray alone.
ONCE_FN void LANED(find)(const Scene* scene, GLOBAL const real* in, GLOBAL const int* left, int count,
                         int stop_at_first, GLOBAL real* t, GLOBAL int* found) {
#if LANES != 1
  int is_packet = RAYS_ARE_ALIKE || LANED(PACKET_OF_ANY_RAYS);
  if (is_packet) {
    LANED(find_packet)(scene, in, left, count, stop_at_first, t, found);
    return;
  }
#endif
  LANED(find_rays)(scene, in, left, count, stop_at_first, t, found);
}

/// found: FOUND_INTS ints a ray and its t, or with STOP_AT_FIRST 1 or 0 a ray alone; FOUND_CUT where loops were ended.
KERNEL LANE_HINT void find(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index,
                           GLOBAL const real* rays, GLOBAL const int* left, GLOBAL real* t, GLOBAL int* found,
                           ulong count) {
  ulong first = get_global_id(0) * LANES;
  if (first >= count) return;
  Scene scene = scene_of(geometry, shading, index);
  int rays_there = count - first < LANES ? (int)(count - first) : LANES;
  ulong ints = STOP_AT_FIRST ? 1 : FOUND_INTS;
  LANED(find)
  (&scene, rays + first * RAY_REALS, left + first * LEFT_INTS, rays_there, STOP_AT_FIRST, t + first,
   found + first * ints);
  if (HAS_LOOP_LIMIT && !loops_were_whole()) found[first * ints + (STOP_AT_FIRST ? 0 : FOUND_KIND)] = FOUND_CUT;
}
