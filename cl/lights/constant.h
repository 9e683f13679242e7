// SPDX-License-Identifier: MIT
// The same radiance from everywhere, seen by rays that leave the scene; every direction is drawn alike. Parameters:
// radiance r g b.
#ifndef STRAHL_LIGHTS_CONSTANT_H
#define STRAHL_LIGHTS_CONSTANT_H

#include "lights/light_sample.h"
#include "math/sampling.h"
#include "samplers/sample_state.h"
#include "scene/scene.h"

FN LightSample constant_sample(const Scene* scene, GLOBAL const int* row, real3 from, Random2 numbers) {
  (void)from;
  LightSample s;
  s.aim = -1;
  s.towards = square_to_sphere(random_between(numbers.x), random_between(numbers.y));
  s.t_max = REAL_MAX;
  s.density = R(0.25) * ONE_OVER_PI;
  s.irradiance = scale3(R(1.0) / s.density, load3(scene->shading + row[LIGHT_REALS]));
  return s;
}

FN real constant_density(const Scene* scene, GLOBAL const int* row, real3 from, const Surface* s, real3 d) {
  (void)scene;
  (void)row;
  (void)from;
  (void)s;
  (void)d;
  return R(0.25) * ONE_OVER_PI;
}

FN real3 constant_background(GLOBAL const real* params) { return load3(params); }

#endif
