// SPDX-License-Identifier: MIT
// What is carried from the camera from surface to surface.
#ifndef STRAHL_CORE_PATH_H
#define STRAHL_CORE_PATH_H

#include "core/ray.h"
#include "samplers/sample_state.h"

typedef struct {
  Ray ray;           ///< The way to the next surface.
  real3 radiance;    ///< Gathered so far.
  real3 throughput;  ///< Share of what comes along `ray` that reaches the camera.
  real3 from;        ///< The point that `ray` has left; of meaning where density > 0.
  real density;      ///< How densely `ray` was drawn, per solid angle; 0: no light could have been drawn instead.
  real travelled;    ///< Length of the ways before `ray`; kept only where there are textures.
  int depth;         ///< Surfaces before `ray`: 0 for a camera ray.
  SampleState sample;
} Path;

FN Path path_begin(Ray camera_ray, SampleState sample) {
  Path path;
  real one = R(1.0), zero = R(0.0);
  path.ray = camera_ray;
  path.radiance = vec3(zero, zero, zero);
  path.throughput = vec3(one, one, one);
  path.from = camera_ray.o;
  path.density = zero;
  path.travelled = zero;
  path.depth = 0;
  path.sample = sample;
  return path;
}

FN void path_add(Path* path, real3 radiance) {
  path->radiance = add3(path->radiance, mul3(path->throughput, radiance));
}

#endif
