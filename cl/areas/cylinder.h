// SPDX-License-Identifier: MIT
// Open cylinder: foot, axis (as long as it is), two perpendicular radii.
#ifndef STRAHL_AREAS_CYLINDER_H
#define STRAHL_AREAS_CYLINDER_H

#include "areas/area_point.h"

FN AreaPoint cylinder_point(GLOBAL const real* item, GLOBAL const real* area, real3 from, real u, real v) {
  real sine, cosine;
  sincos_turns(u, &sine, &cosine);
  real3 outward = fma3(cosine, load3(item + 6), scale3(sine, load3(item + 9)));
  real3 position = add3(fma3(v, load3(item + 3), outward), load3(item));
  return uniform_point(area, from, position, normalize3(scale3(area[AREA_SIDE], outward)));
}

FN real cylinder_density(GLOBAL const real* item, GLOBAL const real* area, real3 from, real3 towards, real3 normal) {
  (void)item;
  (void)from;
  return uniform_density(area, towards, normal);
}

#endif
