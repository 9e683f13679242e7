// SPDX-License-Identifier: MIT
// Sphere, seen from the hit: position, normal, u = phi / 2 pi, v = theta / pi in its own frame.
// Block planes: center x y z, radius. Frame: the three unit axes.
#ifndef STRAHL_SHAPES_SPHERE_H
#define STRAHL_SHAPES_SPHERE_H

#include "core/surface.h"
#include "math/angle.h"

FN void sphere_surface(const Ray* ray, GLOBAL const real* prim, int stride, GLOBAL const real* frame, real t,
                       Surface* s) {
  real3 center = vec3(prim[0], prim[stride], prim[2 * stride]);
  real radius = prim[3 * stride];
  // From the centre, so that a far-off frame costs the direction nothing; then back onto the radius.
  real3 out = fma3(t, ray->d, sub3(ray->o, center));
  s->normal = normalize3(out);
  s->position = fma3(radius, s->normal, center);
  real x = dot3(s->normal, load3(frame));
  real y = dot3(s->normal, load3(frame + 3));
  real z = dot3(s->normal, load3(frame + 6));
  s->u = atan2_turns(y, x);
  s->v = R(2.0) * atan2_turns(real_sqrt(real_fma(x, x, y * y)), z);
}

#endif
