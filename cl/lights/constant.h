// SPDX-License-Identifier: MIT
// The same radiance from everywhere, seen by rays that leave the scene. Parameters: radiance r g b.
// Not sampled as a light: that takes an integrator with area lights.
#ifndef STRAHL_LIGHTS_CONSTANT_H
#define STRAHL_LIGHTS_CONSTANT_H

#include "lights/light_sample.h"

FN LightSample constant_sample(GLOBAL const real* params, real3 from) {
  LightSample s;
  (void)params;
  s.towards = from;
  s.t_max = R(0.0);
  s.irradiance = vec3(R(0.0), R(0.0), R(0.0));
  return s;
}

FN real3 constant_background(GLOBAL const real* params) { return load3(params); }

#endif
