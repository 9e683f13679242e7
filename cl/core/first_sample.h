// SPDX-License-Identifier: MIT
// What is reported of a pixel's first sample beside the picture (scene/layout.h, AOV_...).
#ifndef STRAHL_CORE_FIRST_SAMPLE_H
#define STRAHL_CORE_FIRST_SAMPLE_H

#include "core/surface.h"
#include "scene/layout.h"

typedef struct {
  GLOBAL real* reals;
  GLOBAL int* ints;
  int lane;  ///< Of the paths that are being followed; -1: it is not among them.
} FirstSample;

FN void store_first_sample(const FirstSample* first, const Ray* ray, int hit, real t, const Surface* s) {
  GLOBAL real* reals = first->reals;
  GLOBAL int* ints = first->ints;
  for (int i = 0; i < AOV_REALS; ++i) reals[i] = R(0.0);
  ints[AOV_SHAPE] = -1;
  ints[AOV_PRIMITIVE] = -1;
  GLOBAL real* traced = reals + AOV_RAY;
  traced[RAY_O] = ray->o.x;
  traced[RAY_O + 1] = ray->o.y;
  traced[RAY_O + 2] = ray->o.z;
  traced[RAY_D] = ray->d.x;
  traced[RAY_D + 1] = ray->d.y;
  traced[RAY_D + 2] = ray->d.z;
  traced[RAY_T_MIN] = ray->t_min;
  traced[RAY_T_MAX] = ray->t_max;
  if (!hit) return;
  reals[AOV_T] = t;
  reals[AOV_DEPTH] = length3(sub3(s->position, ray->o));
  reals[AOV_NORMAL] = s->shading.x;
  reals[AOV_NORMAL + 1] = s->shading.y;
  reals[AOV_NORMAL + 2] = s->shading.z;
  reals[AOV_POSITION] = s->position.x;
  reals[AOV_POSITION + 1] = s->position.y;
  reals[AOV_POSITION + 2] = s->position.z;
  reals[AOV_UV] = s->tex_u;
  reals[AOV_UV + 1] = s->tex_v;
  ints[AOV_SHAPE] = s->shape;
  ints[AOV_PRIMITIVE] = s->primitive;
}

#endif
