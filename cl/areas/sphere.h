// SPDX-License-Identifier: MIT
// Sphere: centre, radius. From outside the cone of directions that it fills is drawn uniformly: P. Shirley, C. Wang,
// K. Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations", ACM TOG 15(1), 1996. In terms of 1 - cos and
// of ratios of sines, so that nothing cancels for a sphere that is small or far. From inside, where only one that
// emits inwards is seen, the whole area.
#ifndef STRAHL_AREAS_SPHERE_H
#define STRAHL_AREAS_SPHERE_H

#include "areas/area_point.h"

typedef struct {
  real3 axis;  ///< Unit, towards the centre.
  real sine;   ///< Of half the opening; not below 1: from inside.
  real less;   ///< 1 - its cosine.
} SphereCone;

FN SphereCone sphere_cone(GLOBAL const real* item, real3 from) {
  SphereCone cone;
  real3 to_centre = sub3(load3(item), from);
  real radius = item[3], distance = length3(to_centre);
  cone.axis = scale3(R(1.0) / distance, to_centre);
  cone.sine = radius / distance;
  real square = (distance - radius) * (distance + radius);
  real cosine = square > R(0.0) ? real_sqrt(square) / distance : R(0.0);
  cone.less = cone.sine * cone.sine / (R(1.0) + cosine);
  return cone;
}

FN int sphere_is_outside(SphereCone cone) { return cone.sine < R(1.0); }

FN real sphere_cone_density(GLOBAL const real* area, SphereCone cone) {
  return area[AREA_SIDE] > R(0.0) ? R(0.5) * ONE_OVER_PI / cone.less : R(0.0);
}

FN AreaPoint sphere_point(GLOBAL const real* item, GLOBAL const real* area, real3 from, real u, real v) {
  real3 centre = load3(item);
  SphereCone cone = sphere_cone(item, from);
  if (!sphere_is_outside(cone)) {
    real3 outward = square_to_sphere(u, v);
    return uniform_point(area, from, fma3(item[3], outward, centre), scale3(area[AREA_SIDE], outward));
  }
  real2 disk = square_to_disk(u, v);
  real square = real_fma(disk.x, disk.x, disk.y * disk.y);  // Share of the cone's solid angle.
  real less = square * cone.less, cosine = R(1.0) - less;
  // sin theta / sin theta_max = sqrt(square) ratio; the angle at the centre is asin of that, less theta.
  real ratio = real_sqrt((R(2.0) - less) / (R(2.0) - cone.less));
  real relative = real_fma(-square, ratio * ratio, R(1.0));
  real foot = real_sqrt(relative > R(0.0) ? relative : R(0.0));
  real across = ratio * real_fma(-foot, cone.sine, cosine);
  real along = real_fma(foot, cosine, square * ratio * ratio * cone.sine);
  real3 x, y;
  frame_around(cone.axis, &x, &y);
  AreaPoint p;
  p.normal = normalize3(from_frame(x, y, cone.axis, vec3(across * disk.x, across * disk.y, -along)));
  p.position = fma3(item[3], p.normal, centre);
  p.density = sphere_cone_density(area, cone);
  return p;
}

FN real sphere_density(GLOBAL const real* item, GLOBAL const real* area, real3 from, real3 towards, real3 normal) {
  SphereCone cone = sphere_cone(item, from);
  return sphere_is_outside(cone) ? sphere_cone_density(area, cone) : uniform_density(area, towards, normal);
}

#endif
