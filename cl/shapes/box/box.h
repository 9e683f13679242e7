// SPDX-License-Identifier: MIT
// Axis-aligned box, seen from the hit. Block planes: lo x, hi x, lo y, hi y, lo z, hi z. u = v = 0.
// The coordinate on the face that was hit is set to the face exactly.
#ifndef STRAHL_SHAPES_BOX_H
#define STRAHL_SHAPES_BOX_H

#include "hits/surface.h"

/// Where t is more exact than a quotient (robust tier), or may have been clamped to the interval of an instance
/// (accel/instance.h): the face whose distance is nearest to t, the first of several equally near.
FN int box_face_nearest(PRIVATE const int* near, const Ray* ray, GLOBAL const real* prim, int stride, real t) {
  int best = near[0];
  real gap = REAL_MAX;
  for (int i = 0; i < 6; ++i) {
    int axis = i % 3, face = i < 3 ? near[axis] : near[axis] ^ 1;
    real other = real_abs((prim[face * stride] - component(ray->o, axis)) / component(ray->d, axis) - t);
    if (!(other < gap)) continue;
    gap = other;
    best = face;
  }
  return best;
}

/// The face (0 lo_x, 1 hi_x, 2 lo_y, ...) whose slab distance is t: the first that matches, entries before exits.
FN int box_face(const Ray* ray, GLOBAL const real* prim, int stride, real t) {
  int near[3], i;
#if TIER_FAST
  int face, best = 0;
  real gap = REAL_MAX;
  for (face = 0; face < 6; ++face) {
    real d = component(ray->d, face / 2);
    real other = real_abs(prim[face * stride] - component(ray->o, face / 2) - t * d);
    if (!(d < R(0.0) || R(0.0) < d) || gap <= other) continue;
    gap = other;
    best = face;
  }
  return best;
#endif
  near[0] = ray->near_x;
  near[1] = ray->near_y;
  near[2] = ray->near_z;
  if (HAS_INSTANCES || TIER_ROBUST) return box_face_nearest(near, ray, prim, stride, t);
  for (i = 0; i < 3; ++i)
    if ((prim[near[i] * stride] - component(ray->o, i)) / component(ray->d, i) == t) return near[i];
  for (i = 0; i < 3; ++i)
    if ((prim[(near[i] ^ 1) * stride] - component(ray->o, i)) / component(ray->d, i) == t) return near[i] ^ 1;
  return near[0];
}

FN void box_surface(const Ray* ray, GLOBAL const real* prim, int stride, GLOBAL const real* frame, real t, Surface* s) {
  (void)frame;
  int face = box_face(ray, prim, stride, t);
  real outward = (face & 1) != 0 ? R(1.0) : -R(1.0);
  real zero = R(0.0);
  s->position = ray_at(ray, t);
  s->normal = vec3(zero, zero, zero);
  if (face < 2) {
    s->normal.x = outward;
    s->position.x = prim[face * stride];
  } else if (face < 4) {
    s->normal.y = outward;
    s->position.y = prim[face * stride];
  } else {
    s->normal.z = outward;
    s->position.z = prim[face * stride];
  }
  s->facing = outward * component(ray->d, face / 2);
  s->outline = OUTLINE_BOX;
  s->u = zero;
  s->v = zero;
}

#endif
