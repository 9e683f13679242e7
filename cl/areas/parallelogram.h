// SPDX-License-Identifier: MIT
// Parallelogram: corner, edge u, edge v, unit normal on the side that emits.
#ifndef STRAHL_AREAS_PARALLELOGRAM_H
#define STRAHL_AREAS_PARALLELOGRAM_H

#include "areas/area_point.h"

FN AreaPoint parallelogram_point(GLOBAL const real* item, GLOBAL const real* area, real3 from, real u, real v) {
  real2 weights;
  weights.x = u;
  weights.y = v;
  real3 edge_u = load3(item + 3), edge_v = load3(item + 6);
  real3 position = add3(fma3(weights.x, edge_u, scale3(weights.y, edge_v)), load3(item));
  return uniform_point(area, from, position, load3(item + 9));
}

FN real parallelogram_density(GLOBAL const real* item, GLOBAL const real* area, real3 from, real3 towards,
                              real3 normal) {
  (void)item;
  (void)from;
  return uniform_density(area, towards, normal);
}

#endif
