// SPDX-License-Identifier: MIT
// Infinite plane, seen from the hit. Block planes: anchor x y z, normal x y z (any length, as given).
// Frame: the duals of its spanning vectors u and v, and the point that has u = v = 0. Where u or v is beyond the range
// of real it is 0.
#ifndef STRAHL_SHAPES_PLANE_H
#define STRAHL_SHAPES_PLANE_H

#include "hits/surface.h"

FN void plane_surface(const Ray* ray, GLOBAL const real* prim, int stride, GLOBAL const real* frame, real t,
                      Surface* s) {
  s->normal = normalize3(vec3(prim[3 * stride], prim[4 * stride], prim[5 * stride]));
  s->facing = dot3(s->normal, ray->d);
  s->position = ray_at(ray, t);
  real3 from_origin = fma3(t, ray->d, sub3(ray->o, load3(frame + 6)));
  if (HAS_TANGENT) {
    // Across the normal and the dual of v.
    real3 across = cross3(load3(frame + 3), s->normal);
    s->along = dot3(across, load3(frame)) < R(0.0) ? negate3(across) : across;
  }
  if (HAS_RELIEF) {
    s->grad_u = load3(frame);
    s->grad_v = load3(frame + 3);
  }
  s->u = dot3(from_origin, load3(frame));
  s->v = dot3(from_origin, load3(frame + 3));
}

#endif
