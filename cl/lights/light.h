// SPDX-License-Identifier: MIT
// Dispatch over the active lights, and the light that surfaces emit.
#ifndef STRAHL_LIGHTS_LIGHT_H
#define STRAHL_LIGHTS_LIGHT_H

#include "core/surface.h"
#include "lights/light_sample.h"
#include "lights/all.h"
#include "scene/scene.h"

FN LightSample light_sample(const Scene* scene, int light, real3 from) {
  GLOBAL const int* row = scene->index + scene->index[HEADER_LIGHTS] + light * LIGHT_INTS;
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  LightSample none;
  switch (row[LIGHT_KIND]) {
#define LIGHT(name)  \
  case LIGHT_##name: \
    return name##_sample(params, from);
#include "lights/lights.def"
#undef LIGHT
    default:
      (void)params;
      none.towards = from;
      none.t_max = R(0.0);
      none.irradiance = vec3(R(0.0), R(0.0), R(0.0));
      return none;
  }
}

/// Radiance of a ray that leaves the scene.
FN real3 background_radiance(const Scene* scene) {
  real3 sum = vec3(R(0.0), R(0.0), R(0.0));
  int count = LIGHT_COUNT == 0 ? 0 : scene->index[HEADER_LIGHT_COUNT];
  for (int i = 0; i < count; ++i) {
    GLOBAL const int* row = scene->index + scene->index[HEADER_LIGHTS] + i * LIGHT_INTS;
    GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
    (void)params;
    switch (row[LIGHT_KIND]) {
#define LIGHT(name)                             \
  case LIGHT_##name:                            \
    sum = add3(sum, name##_background(params)); \
    break;
#include "lights/lights.def"
#undef LIGHT
      default:
        break;
    }
  }
  return sum;
}

/// Radiance that the surface emits against the ray's direction: on the side of its normal only.
FN real3 emitted_radiance(const Scene* scene, const Surface* s, real3 ray_direction) {
  real zero = R(0.0);
  if (HAS_EMISSION) {
    int at = scene_part(scene, s->part)[PART_RADIANCE];
    if (at >= 0 && dot3(s->normal, ray_direction) < zero) return load3(scene->shading + at);
  }
  return vec3(zero, zero, zero);
}

#endif
