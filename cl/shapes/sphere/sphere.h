// SPDX-License-Identifier: MIT
// Sphere, seen from the hit: position, normal, u = phi / 2 pi, v = theta / pi in its own frame.
// Block planes: center x y z, radius. Frame: the three unit axes.
#ifndef STRAHL_SHAPES_SPHERE_H
#define STRAHL_SHAPES_SPHERE_H

#include "hits/surface.h"
#include "math/angle.h"

/// The vector from the centre to the hit, for a sphere whose distance is large compared with its radius. There t and o
/// + t d may have steps as large as the sphere. The line's point nearest to the centre, l = d x (f x d) / (d.d), is
/// accurate, and half the chord leads from it to the hit. is_far: the farther of the two hits.
FN real3 sphere_outward_from_afar(const Ray* ray, real3 center, real radius, int is_far) {
  real3 f = sub3(ray->o, center);
  real3 rest = vec3(difference_rest(ray->o.x, center.x, f.x), difference_rest(ray->o.y, center.y, f.y),
                    difference_rest(ray->o.z, center.z, f.z));
  real dd = dot3(ray->d, ray->d);
  real3 moment = add3(cross3(f, ray->d), cross3(rest, ray->d));
  real3 l = scale3(R(1.0) / dd, cross3(ray->d, moment));
  real distance = real_sqrt(dot3(l, l));
  real square = (radius - distance) * (radius + distance) / dd;
  real half_chord = square > R(0.0) ? real_sqrt(square) : R(0.0);
  return fma3(is_far ? half_chord : -half_chord, ray->d, l);
}

FN void sphere_surface(const Ray* ray, GLOBAL const real* prim, int stride, GLOBAL const real* frame, real t,
                       Surface* s) {
  real3 center = vec3(prim[0], prim[stride], prim[2 * stride]);
  real radius = prim[3 * stride];
  // Relative to the centre, so that the direction loses nothing in a distant frame; then scaled to the radius.
  real3 f = sub3(ray->o, center);
  real3 out = fma3(t, ray->d, f);
  s->facing = dot3(out, ray->d);
#if !TIER_FAST
  if (dot3(f, f) > R(16.0) * radius * radius) {
    // The far root only where t shows it beyond its own rounding.
    int is_far = t + dot3(f, ray->d) / dot3(ray->d, ray->d) > R(8.0) * real_roundoff() * real_abs(t);
    out = sphere_outward_from_afar(ray, center, radius, is_far);
    s->facing = is_far ? R(1.0) : -R(1.0);
  }
#endif
  s->outline = OUTLINE_ROUND;
  s->off = round_off(radius);
  s->normal = normalize3(out);
  s->position = fma3(radius, s->normal, center);
  real x = dot3(s->normal, load3(frame));
  real y = dot3(s->normal, load3(frame + 3));
  real z = dot3(s->normal, load3(frame + 6));
  if (HAS_TANGENT) s->along = fma3(x, load3(frame + 3), scale3(-y, load3(frame)));
  real sine = real_sqrt(real_fma(x, x, y * y));
  if (HAS_RELIEF && sine > R(0.0)) {
    // Along the circles of latitude, and from the pole z down.
    real3 outward = scale3(R(1.0) / sine, fma3(x, load3(frame), scale3(y, load3(frame + 3))));
    real3 around = scale3(R(1.0) / sine, fma3(x, load3(frame + 3), scale3(-y, load3(frame))));
    s->grad_u = scale3(ONE_OVER_TWO_PI / (radius * sine), around);
    s->grad_v = scale3(R(2.0) * ONE_OVER_TWO_PI / radius, fma3(z, outward, scale3(-sine, load3(frame + 6))));
  }
  s->u = atan2_turns(y, x);
  s->v = R(2.0) * atan2_turns(sine, z);
}

#endif
