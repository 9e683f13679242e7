// SPDX-License-Identifier: MIT
// A place on a surface that emits, as seen from elsewhere.
#ifndef STRAHL_AREAS_AREA_POINT_H
#define STRAHL_AREAS_AREA_POINT_H

#include "math/sampling.h"
#include "scene/layout.h"

typedef struct {
  real3 position;
  real3 normal;  ///< Unit, on the side that emits.
  real density;  ///< Per solid angle; 0: its back is turned.
} AreaPoint;

/// Of a place drawn uniformly from the whole area.
FN real uniform_density(GLOBAL const real* area, real3 towards, real3 normal) {
  real square = dot3(towards, towards), facing = -dot3(normal, towards);
  return facing > R(0.0) ? area[AREA_INVERSE] * (square * real_sqrt(square)) / facing : R(0.0);
}

FN AreaPoint uniform_point(GLOBAL const real* area, real3 from, real3 position, real3 normal) {
  AreaPoint p;
  p.position = position;
  p.normal = normal;
  p.density = uniform_density(area, sub3(position, from), normal);
  return p;
}

#endif
