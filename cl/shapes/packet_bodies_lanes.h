// SPDX-License-Identifier: MIT
// Which kinds of primitive have a body for packets: one primitive in every lane, a ray in each. The others' rays are
// asked one by one. One width; no guard.
#ifndef STRAHL_PACKET_BODIES
#define STRAHL_PACKET_BODIES
enum { PACKET_BODY_NONE, PACKET_BODY_TRIANGLE, PACKET_BODY_SPHERE };
enum {
  PACKET_BODY_sphere = PACKET_BODY_SPHERE,
  PACKET_BODY_plane = PACKET_BODY_NONE,
  PACKET_BODY_box = PACKET_BODY_NONE,
  PACKET_BODY_triangle = PACKET_BODY_TRIANGLE,
  PACKET_BODY_parallelogram = PACKET_BODY_NONE,
  PACKET_BODY_disk = PACKET_BODY_NONE,
  PACKET_BODY_cylinder = PACKET_BODY_NONE
};
#endif
#if TIER_ROBUST
#include "shapes/packet_rough_lanes.h"
#endif
#include "shapes/triangle_packet_lanes.h"
#include "shapes/sphere_packet_lanes.h"
