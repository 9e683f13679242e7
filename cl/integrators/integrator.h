// SPDX-License-Identifier: MIT
// One surface of a path: dispatch over the active integrators, then light from lamps and the way on, each in one place
// for all integrators, so that a program holds one traversal for shadows and one for everything else.
// One width; no guard.
#include "core/counters.h"
#include "core/departure.h"
#include "core/footprint.h"
#include "core/path.h"
#include "lights/light.h"
#include "materials/material.h"

enum {
  STEP_LAMPS = 1,  ///< Add the light that point and directional lights throw on the surface.
  STEP_MIRROR = 2  ///< Follow the mirrored ray.
};

/// What comes along the path's ray by itself: the surface's emission, or the background where nothing is hit.
FN real3 radiance_along(const Scene* scene, const Path* path, int hit, const Surface* s) {
  return hit ? emitted_radiance(scene, s, path->ray.d) : background_radiance(scene);
}

#include "integrators/all.h"

FN void LANED(add_lamps)(const Scene* scene, Path* path, const Surface* s, int id, real3 wo) {
  real zero = R(0.0);
  int lights = LIGHT_COUNT == 0 ? 0 : scene->index[HEADER_LIGHT_COUNT];
  for (int i = 0; i < lights; ++i) {
    LightSample light = light_sample(scene, i, s->position);
    if (!(max3(light.irradiance) > zero)) continue;
    real3 reflected = mul3(material_eval(scene, s, normalize3(light.towards), wo), light.irradiance);
    if (!(max3(reflected) > zero)) continue;
    Ray shadow = ray_leaving(s, id, light.towards, light.t_max);
    if (HAS_COUNT_RAYS) count_event(scene, COUNT_SHADOW);
    if (!LANED(any_hit)(scene, &shadow)) path_add(path, reflected);
  }
}

/// 0: all light that the way on could bring is lost.
FN int path_mirror(const Scene* scene, Path* path, const Surface* s, int id, real3 wo) {
  path->throughput = mul3(path->throughput, material_mirror(scene, s, wo));
  if (!(max3(path->throughput) > R(0.0))) return 0;
  // Normalised anew each time: the length does not drift however many mirrors follow.
  real3 on = normalize3(fma3(R(2.0) * dot3(s->shading, wo), s->shading, negate3(wo)));
  if (HAS_COUNT_RAYS) count_event(scene, COUNT_BOUNCE);
  path->ray = ray_leaving(s, id, on, REAL_MAX);
  ++path->depth;
  return 1;
}

/// Takes the path over one surface, with id scene-wide; 1: to be followed along its new ray.
FN int LANED(path_step)(const Scene* scene, Path* path, int hit, Surface* s, int id) {
  int next = 0;
  if (TEXTURE_COUNT > 0 && hit) {
    path->travelled += length3(sub3(s->position, path->ray.o));
    s->footprint = pixel_footprint(scene, path->travelled, s, path->ray.d);
  }
  switch (scene->index[HEADER_INTEGRATOR]) {
#define INTEGRATOR(name)                     \
  case INTEGRATOR_##name:                    \
    next = name##_step(scene, path, hit, s); \
    break;
#include "integrators/integrators.def"
#undef INTEGRATOR
    default:
      break;
  }
  if (next == 0) return 0;
  real3 wo = normalize3(negate3(path->ray.d));
  if ((next & STEP_LAMPS) != 0) LANED(add_lamps)(scene, path, s, id, wo);
  return (next & STEP_MIRROR) != 0 ? path_mirror(scene, path, s, id, wo) : 0;
}
