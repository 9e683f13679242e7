// SPDX-License-Identifier: MIT
// A way from a surface into the open, drawn in proportion to its cosine: S. Zhukov, A. Iones, G. Kronin, "An Ambient
// Light Illumination Model", EGWR 1998.
#ifndef STRAHL_CORE_OPENNESS_H
#define STRAHL_CORE_OPENNESS_H

#include "core/path.h"
#include "core/surface.h"
#include "lights/light_sample.h"
#include "math/sampling.h"
#include "samplers/sampler.h"

/// On the side of wo; what it brings is white.
FN LightSample sky_sample(const Scene* scene, const Path* path, const Surface* s, real3 wo) {
  Random2 numbers = sample_pair(scene, &path->sample, set_at(path->depth, SET_WAY));
  real3 z = dot3(wo, s->shading) < R(0.0) ? negate3(s->shading) : s->shading, x, y;
  frame_around(z, &x, &y);
  LightSample sky;
  sky.aim = -1;
  sky.towards = from_frame(x, y, z, square_to_cosine_hemisphere(random_between(numbers.x), random_between(numbers.y)));
  sky.t_max = scene->shading[scene->index[HEADER_REACH]];
  sky.irradiance = vec3(R(1.0), R(1.0), R(1.0));
  sky.density = R(0.0);
  return sky;
}

#endif
