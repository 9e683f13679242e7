// SPDX-License-Identifier: MIT
// Triangle, seen from the hit: u and v are the weights of the second and third vertex.
// Block planes: p0 x y z, p1 x y z, p2 x y z.
#ifndef STRAHL_SHAPES_TRIANGLE_H
#define STRAHL_SHAPES_TRIANGLE_H

#include "hits/edge_gradients.h"
#include "shapes/polygon/edges.h"
#include "shapes/polygon/near_point.h"

FN void triangle_surface(const Ray* ray, GLOBAL const real* prim, int stride, GLOBAL const real* frame, real t,
                         Surface* s) {
  (void)frame;
  (void)t;
  real3 p0 = corner_load(prim, stride, 0), p1 = corner_load(prim, stride, 1), p2 = corner_load(prim, stride, 2);
  real3 e1 = sub3(p1, p0), e2 = sub3(p2, p0);
  barycentrics(ray, p0, p1, p2, &s->u, &s->v);
  // The base vertex last: the sum is then good to the ulp of the vertex.
  s->position = add3(fma3(s->u, e1, scale3(s->v, e2)), p0);
  s->normal = normalize3(cross3(e1, e2));
  s->facing = dot3(s->normal, ray->d);
  if (HAS_TANGENT) s->along = e1;
  if (HAS_RELIEF) take_edge_gradients(e1, e2, s);
  take_near_point(ray, p0, e1, e2, s);
  s->outline = OUTLINE_TRIANGLE;
}

#endif
