// SPDX-License-Identifier: MIT
// Dispatch over the active textures.
#ifndef STRAHL_TEXTURES_TEXTURE_H
#define STRAHL_TEXTURES_TEXTURE_H

#include "scene/scene.h"
#include "textures/all.h"

/// The values of a surface point that textures use (hits/surface.h).
typedef struct {
  int part;
  real u, v, footprint;
} TexturePoint;

FN real3 texture_value(const Scene* scene, int texture, const TexturePoint* at) {
  GLOBAL const int* row = scene->index + scene->index[HEADER_TEXTURES] + texture * TEXTURE_INTS;
  GLOBAL const real* params = scene->shading + row[TEXTURE_REALS];
  GLOBAL const real* rates = scene->shading + scene_part(scene, at->part)[PART_UV_RATES];
  real du = at->footprint * rates[0], dv = at->footprint * rates[1];
  real zero = R(0.0);
  switch (row[TEXTURE_KIND]) {
#define TEXTURE(name)  \
  case TEXTURE_##name: \
    return name##_value(params, at->u, at->v, du, dv);
#include "textures/textures.def"
#undef TEXTURE
    default:
      (void)params;
      (void)du;
      (void)dv;
      return vec3(zero, zero, zero);
  }
}

#endif
