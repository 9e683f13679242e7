// SPDX-License-Identifier: MIT
// Point light: intensity / distance^2. Parameters: position x y z, intensity r g b (W/sr).
#ifndef STRAHL_LIGHTS_POINT_H
#define STRAHL_LIGHTS_POINT_H

#include "lights/light_sample.h"
#include "samplers/sample_state.h"
#include "scene/scene.h"

FN LightSample point_sample(const Scene* scene, GLOBAL const int* row, real3 from, Random2 numbers) {
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  (void)numbers;
  LightSample s;
  s.aim = -1;
  s.towards = sub3(load3(params), from);
  s.t_max = R(1.0);
  real distance = length3(s.towards);
  real inverse = R(1.0) / distance;
  s.irradiance = scale3(inverse, scale3(inverse, load3(params + 3)));
  s.density = R(0.0);
  return s;
}

FN real point_density(const Scene* scene, GLOBAL const int* row, real3 from, const Surface* s, real3 d) {
  (void)scene;
  (void)row;
  (void)from;
  (void)s;
  (void)d;
  return R(0.0);
}

FN real3 point_background(GLOBAL const real* params) {
  (void)params;
  return vec3(R(0.0), R(0.0), R(0.0));
}

#endif
