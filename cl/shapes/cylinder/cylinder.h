// SPDX-License-Identifier: MIT
// Open cylinder, seen from the hit: normal away from the axis, u = angle / 2 pi from its reference, v along the axis.
// Block planes: p0 x y z, unit axis x y z, length, radius. Frame: reference, axis x reference (unit).
#ifndef STRAHL_SHAPES_CYLINDER_H
#define STRAHL_SHAPES_CYLINDER_H

#include "hits/surface.h"
#include "math/angle.h"

FN void cylinder_surface(const Ray* ray, GLOBAL const real* prim, int stride, GLOBAL const real* frame, real t,
                         Surface* s) {
  real3 p0 = vec3(prim[0], prim[stride], prim[2 * stride]);
  real3 axis = vec3(prim[3 * stride], prim[4 * stride], prim[5 * stride]);
  real length = prim[6 * stride], radius = prim[7 * stride];
  real3 from_p0 = fma3(t, ray->d, sub3(ray->o, p0));
  real along = dot3(from_p0, axis);
  s->outline = OUTLINE_ROUND;
  s->off = round_off(length + radius);
  s->normal = normalize3(fma3(-along, axis, from_p0));
  s->facing = dot3(s->normal, ray->d);
  if (HAS_TANGENT) s->along = cross3(axis, s->normal);
  s->position = add3(fma3(radius, s->normal, scale3(along, axis)), p0);
  if (HAS_RELIEF) {
    s->grad_u = scale3(ONE_OVER_TWO_PI / radius, cross3(axis, s->normal));
    s->grad_v = scale3(R(1.0) / length, axis);
  }
  real v = along / length;
  s->u = atan2_turns(dot3(s->normal, load3(frame + 3)), dot3(s->normal, load3(frame)));
  s->v = v > R(0.0) ? (v < R(1.0) ? v : R(1.0)) : R(0.0);
}

#endif
