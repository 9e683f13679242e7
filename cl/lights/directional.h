// SPDX-License-Identifier: MIT
// Light from infinitely far away. Parameters: unit direction of travel x y z, irradiance r g b (W/m^2).
#ifndef STRAHL_LIGHTS_DIRECTIONAL_H
#define STRAHL_LIGHTS_DIRECTIONAL_H

#include "lights/light_sample.h"

FN LightSample directional_sample(GLOBAL const real* params, real3 from) {
  LightSample s;
  (void)from;
  s.towards = negate3(load3(params));
  s.t_max = REAL_MAX;
  s.irradiance = load3(params + 3);
  return s;
}

FN real3 directional_background(GLOBAL const real* params) {
  (void)params;
  return vec3(R(0.0), R(0.0), R(0.0));
}

#endif
