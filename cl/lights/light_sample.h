// SPDX-License-Identifier: MIT
// What a point of a surface learns of a light.
#ifndef STRAHL_LIGHTS_LIGHT_SAMPLE_H
#define STRAHL_LIGHTS_LIGHT_SAMPLE_H

#include "math/vec3.h"

typedef struct {
  real3 towards;     ///< To the light; where it has a place, exactly to it: t = 1 is the light.
  real t_max;        ///< How far along `towards` the way must be free.
  real3 irradiance;  ///< On a surface perpendicular to `towards`; zero: no light from there.
  int aim;           ///< Id of the flat primitive that the place is on; -1: none.
  real density;      ///< Of that direction, per solid angle; 0: it is the only one.
} LightSample;

#endif
