// SPDX-License-Identifier: MIT
// Parallelogram (rectangle, face of a cube), seen from the hit: position = corner + u edge_u + v edge_v.
// Block planes: corners A, B = A + edge_u, C = A + edge_u + edge_v, D = A + edge_v.
#ifndef STRAHL_SHAPES_PARALLELOGRAM_H
#define STRAHL_SHAPES_PARALLELOGRAM_H

#include "hits/edge_gradients.h"
#include "shapes/polygon/edges.h"
#include "shapes/polygon/near_point.h"

FN void parallelogram_surface(const Ray* ray, GLOBAL const real* prim, int stride, GLOBAL const real* frame, real t,
                              Surface* s) {
  (void)frame;
  (void)t;
  real3 a = corner_load(prim, stride, 0), b = corner_load(prim, stride, 1), d = corner_load(prim, stride, 3);
  real3 edge_u = sub3(b, a), edge_v = sub3(d, a);
  barycentrics(ray, a, b, d, &s->u, &s->v);
  s->position = add3(fma3(s->u, edge_u, scale3(s->v, edge_v)), a);
  s->normal = normalize3(cross3(edge_u, edge_v));
  s->facing = dot3(s->normal, ray->d);
  if (HAS_TANGENT) s->along = edge_u;
  if (HAS_RELIEF) take_edge_gradients(edge_u, edge_v, s);
  take_near_point(ray, a, edge_u, edge_v, s);
  s->outline = OUTLINE_PARALLELOGRAM;
}

#endif
