// SPDX-License-Identifier: MIT
// Dispatch over the active integrators. One width; no guard.
#include "lights/light.h"
#include "materials/material.h"
#include "core/counters.h"
#include "integrators/all.h"

FN real3 radiance_of(const Scene* scene, const Ray* ray, int hit, const Surface* s, int id) {
  switch (scene->index[HEADER_INTEGRATOR]) {
#define INTEGRATOR(name)  \
  case INTEGRATOR_##name: \
    return name##_radiance(scene, ray, hit, s, id);
#include "integrators/integrators.def"
#undef INTEGRATOR
    default:
      (void)ray;
      (void)hit;
      (void)s;
      (void)id;
      return vec3(R(0.0), R(0.0), R(0.0));
  }
}
