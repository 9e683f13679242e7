// SPDX-License-Identifier: MIT
// Dispatch over the active lights, and the light that surfaces emit.
#ifndef STRAHL_LIGHTS_LIGHT_H
#define STRAHL_LIGHTS_LIGHT_H

#include "core/surface.h"
#include "lights/light_sample.h"
#include "lights/all.h"
#include "samplers/sample_state.h"
#include "scene/scene.h"

FN GLOBAL const int* light_row(const Scene* scene, int light) {
  return scene->index + scene->index[HEADER_LIGHTS] + light * LIGHT_INTS;
}

FN LightSample light_sample(const Scene* scene, int light, real3 from, Random2 numbers) {
  GLOBAL const int* row = light_row(scene, light);
  LightSample none;
  switch (row[LIGHT_KIND]) {
#define LIGHT(name)  \
  case LIGHT_##name: \
    return name##_sample(scene, row, from, numbers);
#include "lights/lights.def"
#undef LIGHT
    default:
      (void)numbers;
      none.towards = from;
      none.aim = -1;
      none.t_max = none.density = R(0.0);
      none.irradiance = vec3(R(0.0), R(0.0), R(0.0));
      return none;
  }
}

/// Of direction d, along which a ray has found the light, at s if it is a surface.
FN real light_density(const Scene* scene, int light, real3 from, const Surface* s, real3 d) {
  GLOBAL const int* row = light_row(scene, light);
  switch (row[LIGHT_KIND]) {
#define LIGHT(name)  \
  case LIGHT_##name: \
    return name##_density(scene, row, from, s, d);
#include "lights/lights.def"
#undef LIGHT
    default:
      (void)from;
      (void)s;
      (void)d;
      return R(0.0);
  }
}

/// Radiance of a ray that leaves the scene.
FN real3 background_radiance(const Scene* scene) {
  real3 none = vec3(R(0.0), R(0.0), R(0.0));
  int light = LIGHT_COUNT == 0 ? -1 : scene->index[HEADER_BACKGROUND];
  if (light < 0) return none;
  GLOBAL const int* row = light_row(scene, light);
  GLOBAL const real* params = scene->shading + row[LIGHT_REALS];
  (void)params;
  switch (row[LIGHT_KIND]) {
#define LIGHT(name)  \
  case LIGHT_##name: \
    return name##_background(params);
#include "lights/lights.def"
#undef LIGHT
    default:
      return none;
  }
}

/// The camera looks through what glows.
FN int hides_emitters(const Scene* scene) { return HAS_HIDE_EMITTERS && scene->index[HEADER_HIDE_EMITTERS] != 0; }

/// Radiance that the surface emits against the ray's direction: on the side of its normal only.
FN real3 emitted_radiance(const Scene* scene, const Surface* s) {
  real zero = R(0.0);
  if (HAS_EMISSION) {
    int at = scene_part(scene, s->part)[PART_RADIANCE];
    if (at >= 0 && s->facing < zero) return load3(scene->shading + at);
  }
  return vec3(zero, zero, zero);
}

#endif
