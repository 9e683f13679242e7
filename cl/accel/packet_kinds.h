// SPDX-License-Identifier: MIT
// Which kinds of primitive have a body for packets: one primitive in every lane, a ray in each. The others' rays are
// asked one by one. One width; no guard but for what has none.
#ifndef STRAHL_PACKET_BODIES
#define STRAHL_PACKET_BODIES
enum { PACKET_BODY_NONE, PACKET_BODY_TRIANGLE, PACKET_BODY_SPHERE, PACKET_BODY_PLANE };
enum {
  PACKET_BODY_sphere = PACKET_BODY_SPHERE,
  PACKET_BODY_plane = PACKET_BODY_PLANE,
  PACKET_BODY_box = PACKET_BODY_NONE,
  PACKET_BODY_triangle = PACKET_BODY_TRIANGLE,
  PACKET_BODY_parallelogram = PACKET_BODY_NONE,
  PACKET_BODY_disk = PACKET_BODY_NONE,
  PACKET_BODY_cylinder = PACKET_BODY_NONE
};
#endif

/// 1: rays need not be alike: nothing but lists, of kinds whose bodies ask for nothing that is common to all rays.
enum {
  LANED(PACKET_OF_ANY_RAYS) = !HAS_TREE
#define SHAPE(name, planes) &(PACKET_BODY_##name == PACKET_BODY_PLANE || PACKET_BODY_##name == PACKET_BODY_SPHERE)
#include "shapes/shapes.def"
#undef SHAPE
#if REAL_BITS == 64
                              & 0
#endif
};
