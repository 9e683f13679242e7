// SPDX-License-Identifier: MIT
// Corners of flat polygons as their blocks hold them.
#ifndef STRAHL_SHAPES_CORNERS_H
#define STRAHL_SHAPES_CORNERS_H

#include "math/vec3.h"

/// The vertex at planes 3 corner ... 3 corner + 2.
FN real3 corner_load(GLOBAL const real* prim, int stride, int corner) {
  return vec3(prim[3 * corner * stride], prim[(3 * corner + 1) * stride], prim[(3 * corner + 2) * stride]);
}

#endif
