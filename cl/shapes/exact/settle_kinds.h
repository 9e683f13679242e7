// SPDX-License-Identifier: MIT
// The exact t of a hit that was put off (put_off.h), by what the program's kinds of primitives call for. Functions that
// are called are compiled before a compiler finds that the call is dead: of programs without spheres their exact roots
// were a fifth. Needs the kinds' bodies.
#ifndef STRAHL_SHAPES_EXACT_SETTLE_KINDS_H
#define STRAHL_SHAPES_EXACT_SETTLE_KINDS_H

/// 1: spheres, polygons among the kinds whose hits are put off.
enum {
  SPHERES_ARE_PUT_OFF = ((int)SPHERES_WAIT != 0) & (0
#define SHAPE(name, planes) | ((int)PACKET_BODY_##name##_w == (int)PACKET_BODY_SPHERE)
#include "shapes/shapes.def"
#undef SHAPE
                                                    ),
  POLYGONS_ARE_PUT_OFF = 0
#define SHAPE(name, planes) | ((int)PACKET_BODY_##name##_w < (int)PACKET_BODY_SPHERE)
#include "shapes/shapes.def"
#undef SHAPE
};

ONCE_FN real exact_t(const Ray* ray, real approximate, GLOBAL const real* prim, int points, int stride) {
  if (SPHERES_ARE_PUT_OFF && points == 1) return sphere_exact_t(ray, prim, stride);
  if (POLYGONS_ARE_PUT_OFF) return polygon_exact_t(ray, approximate, prim, points, stride);
  return approximate;
}

#endif
