// SPDX-License-Identifier: MIT
// Disk, seen from the hit: u = distance from the centre in radii, v = angle / 2 pi from its first axis.
// Block planes: center x y z, normal x y z (any length), radius squared. Frame: axis_u / r^2, axis_v / r^2.
#ifndef STRAHL_SHAPES_DISK_H
#define STRAHL_SHAPES_DISK_H

#include "hits/surface.h"
#include "math/angle.h"

FN void disk_surface(const Ray* ray, GLOBAL const real* prim, int stride, GLOBAL const real* frame, real t,
                     Surface* s) {
  real3 center = vec3(prim[0], prim[stride], prim[2 * stride]);
  s->normal = normalize3(vec3(prim[3 * stride], prim[4 * stride], prim[5 * stride]));
  s->facing = dot3(s->normal, ray->d);
  real3 from_center = fma3(t, ray->d, sub3(ray->o, center));
  s->position = add3(from_center, center);
  real x = dot3(from_center, load3(frame)), y = dot3(from_center, load3(frame + 3));
  s->u = real_sqrt(real_fma(x, x, y * y));
  if (s->u > R(1.0)) s->u = R(1.0);
  if (HAS_TANGENT) s->along = fma3(x, load3(frame), scale3(y, load3(frame + 3)));
  if (HAS_RELIEF && s->u > R(0.0)) {
    real inverse = R(1.0) / s->u, turn = ONE_OVER_TWO_PI * inverse;
    real cosine = x * inverse, sine = y * inverse;
    s->grad_u = fma3(cosine, load3(frame), scale3(sine, load3(frame + 3)));
    s->grad_v = scale3(turn, fma3(cosine, load3(frame + 3), scale3(-sine, load3(frame))));
  }
  s->v = atan2_turns(y, x);
}

#endif
