// SPDX-License-Identifier: MIT
// How wide a pixel is on a surface, for the filters of textures: its width at the camera's axis, grown with the whole
// way from the camera, over the cosine at the surface. The same in every direction of the surface, so too wide across
// the slant; curved mirrors are taken for flat ones. On instances it is counted in the group's lengths, as rates of u
// and v are, by the direction that an instance stretches most.
#ifndef STRAHL_TEXTURES_FOOTPRINT_H
#define STRAHL_TEXTURES_FOOTPRINT_H

#include "hits/surface.h"
#include "scene/scene.h"

FN real pixel_footprint(const Scene* scene, real travelled, const Surface* s, real3 d) {
  GLOBAL const real* camera = scene->shading + scene->index[HEADER_CAMERA];
  real spread = length3(load3(camera + CAMERA_DX)) / length3(load3(camera + CAMERA_D));
  real half_width = real_fma(spread, travelled, length3(load3(camera + CAMERA_OX)));
  real cosine = real_abs(dot3(s->normal, d)) / length3(d);
  real width = R(2.0) * half_width / ((real)scene->index[HEADER_WIDTH] * cosine);
  if (HAS_INSTANCES && s->instance >= 0) width *= s->placed[INSTANCE_SHRINK];
  return width;
}

#endif
