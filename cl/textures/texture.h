// SPDX-License-Identifier: MIT
// Dispatch over the active textures.
#ifndef STRAHL_TEXTURES_TEXTURE_H
#define STRAHL_TEXTURES_TEXTURE_H

#include "core/surface.h"
#include "scene/scene.h"
#include "textures/all.h"

FN real3 texture_value(const Scene* scene, int texture, const Surface* s) {
  GLOBAL const int* row = scene->index + scene->index[HEADER_TEXTURES] + texture * TEXTURE_INTS;
  GLOBAL const real* params = scene->shading + row[TEXTURE_REALS];
  GLOBAL const real* rates = scene->shading + scene_part(scene, s->part)[PART_UV_RATES];
  real du = s->footprint * rates[0], dv = s->footprint * rates[1];
  real zero = R(0.0);
  switch (row[TEXTURE_KIND]) {
#define TEXTURE(name)  \
  case TEXTURE_##name: \
    return name##_value(params, s->tex_u, s->tex_v, du, dv);
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
