// SPDX-License-Identifier: MIT
// The kernel `find`, LANES rays a work-item (hits/trace_one.h): where rays hit or, with STOP_AT_FIRST 1, whether they
// hit. Each of the two is a program of its own, because the traversal is most of a program and few callers need both.
// One width; no guard.
#include "math/vec3.h"
#include "lanes/lane_ops.h"
#include "hits/trace_one.h"
#include "kernels/whole_loops.h"
#if LANES != 1
#include "accel/packet.h"
#endif

/// 1: the rays of a work-item are expected to be coherent and are traversed as a packet (accel/packet.h); the hits are
/// the same.
#ifndef RAYS_ARE_ALIKE
#define RAYS_ARE_ALIKE 0
#endif

#if LANES != 1
/// find_rays of hits/trace_one.h for packets.
ONCE_FN void find_packet_w(const Scene* scene, GLOBAL const real* in, GLOBAL const int* departed, int stop_at_first,
                           GLOBAL real* t, GLOBAL int* found) {
  Rays_w rays;
  rays_given_w(scene, in, departed, &rays);
  NearestEach_w hits = packet_traverse_w(scene, &rays, stop_at_first ? FIND_ANY : FIND_NEAREST);
  if (stop_at_first) {
    write_int_w(sel_int_w(lt_int_w(hits.kind, splat_int_w(0)), splat_int_w(0), splat_int_w(1)), found);
    return;
  }
  write_w(hits.t, t);
  write_int_w(hits.id, found + FOUND_ID * LANES);
  write_int_w(hits.kind, found + FOUND_KIND * LANES);
  write_int_w(hits.slot, found + FOUND_SLOT * LANES);
  if (HAS_INSTANCES) write_int_w(hits.instance, found + FOUND_INSTANCE * LANES);
}
#endif

/// Where all primitives are listed, and their kinds require nothing that is common to all rays, even incoherent rays
/// are traversed as a packet: otherwise much of the time goes into work that is done for each ray alone.
ONCE_FN void find_w(const Scene* scene, GLOBAL const real* in, GLOBAL const int* departed, int count, int stop_at_first,
                    GLOBAL real* t, GLOBAL int* found) {
#if LANES != 1
  int is_packet = RAYS_ARE_ALIKE || PACKET_OF_ANY_RAYS_w;
  if (is_packet) {
    find_packet_w(scene, in, departed, stop_at_first, t, found);
    return;
  }
#endif
  find_rays_w(scene, in, departed, count, stop_at_first, t, found);
}

/// Number of rays in the block that begins with ray `first`.
FN int rays_there_w(ulong first, ulong count) { return count - first < LANES ? (int)(count - first) : LANES; }

/// found, t: blocks of FOUND_INTS planes and a plane, or with STOP_AT_FIRST only one of ints, 1 or 0. FOUND_CUT where
/// the device has ended loops.
KERNEL LANE_HINT void find(GLOBAL const real* geometry, GLOBAL const real* shading, GLOBAL const int* index,
                           GLOBAL const real* rays, GLOBAL const int* departed, GLOBAL real* t, GLOBAL int* found,
                           ulong count) {
  ulong first = get_global_id(0) * LANES;
  if (first >= count) return;
  Scene scene = scene_of(geometry, shading, index, (GLOBAL uint*)0);
  ulong ints = STOP_AT_FIRST ? 1 : FOUND_INTS;
  find_w(&scene, rays + first * RAY_REALS, departed + first * DEPARTED_INTS, rays_there_w(first, count), STOP_AT_FIRST,
         t + first, found + first * ints);
  if (HAS_LOOP_LIMIT && !loops_were_whole()) found[first * ints + (STOP_AT_FIRST ? 0 : FOUND_KIND * LANES)] = FOUND_CUT;
}
