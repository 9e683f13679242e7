// SPDX-License-Identifier: MIT
// Light from infinitely far away. Parameters: unit direction of travel x y z, irradiance r g b (W/m^2).
#ifndef STRAHL_LIGHTS_DIRECTIONAL_H
#define STRAHL_LIGHTS_DIRECTIONAL_H

#include "lights/light_sample.h"
#include "samplers/sample_state.h"
#include "scene/scene.h"

FN LightSample directional_sample(const Scene* scene, GLOBAL const int* row, real3 from, Random2 numbers) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  (void)from;
  (void)numbers;
  LightSample s;
  s.aim = -1;
  s.towards = negate3(load3(params));
  s.t_max = REAL_MAX;
  s.irradiance = load3(params + 3);
  s.density = R(0.0);
  return s;
}

FN real directional_density(const Scene* scene, GLOBAL const int* row, real3 from, const Surface* s, real3 d) {
  (void)scene;
  (void)row;
  (void)from;
  (void)s;
  (void)d;
  return R(0.0);
}

FN real3 directional_background(GLOBAL const real* params) {
  (void)params;
  return vec3(R(0.0), R(0.0), R(0.0));
}

#endif
