// SPDX-License-Identifier: MIT
// A way on from a surface, in its frame.
#ifndef STRAHL_MATERIALS_MATERIAL_SAMPLE_H
#define STRAHL_MATERIALS_MATERIAL_SAMPLE_H

#include "math/sampling.h"

typedef struct {
  real3 wi;      ///< Unit.
  real3 weight;  ///< f times |cos| over the density; black: the path ends.
  real density;  ///< Per solid angle; 0: of all directions only this one reflects (a mirror), no light could be drawn.
} MaterialSample;

FN real3 black3(void) { return vec3(R(0.0), R(0.0), R(0.0)); }

#endif
