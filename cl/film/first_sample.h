// SPDX-License-Identifier: MIT
// The values of each pixel's first sample that are reported beside the picture (scene/layout.h, AOV_...).
#ifndef STRAHL_FILM_FIRST_SAMPLE_H
#define STRAHL_FILM_FIRST_SAMPLE_H

#include "hits/surface.h"
#include "scene/layout.h"

typedef struct {
  GLOBAL real* reals;  ///< The first pixel's of a span; the others' follow.
  GLOBAL int* ints;
  int first_pixel;  ///< Its number in the picture.
  int from, end;    ///< Pixels [from, end) of the span are in the picture; the others' are not kept.
  uint lanes;       ///< Those of the paths being followed that are first samples on their first ray, a bit each.
} FirstSamples;

FN int is_first_sample(const FirstSamples* first, int lane) { return HAS_AOV && (first->lanes >> lane & 1u) != 0u; }

/// Where a pixel's are.
FN GLOBAL real* first_reals(const FirstSamples* first, int pixel) {
  return first->reals + (ulong)(pixel - first->first_pixel) * AOV_REALS;
}

FN void store_first_sample(const FirstSamples* first, int pixel, const Ray* ray, int hit, real t, const Surface* s) {
  GLOBAL real* reals = first_reals(first, pixel);
  GLOBAL int* ints = first->ints + (ulong)(pixel - first->first_pixel) * AOV_INTS;
  for (int i = 0; i < AOV_REALS; ++i) reals[i] = R(0.0);
  ints[AOV_SHAPE] = -1;
  ints[AOV_PRIMITIVE] = -1;
  GLOBAL real* traced = reals + AOV_RAY;
  store3(ray->o, traced + RAY_O);
  store3(ray->d, traced + RAY_D);
  traced[RAY_T_MIN] = ray->t_min;
  traced[RAY_T_MAX] = ray->t_max;
  if (!hit) return;
  reals[AOV_T] = t;
  reals[AOV_DEPTH] = length3(sub3(s->position, ray->o));
  store3(s->shading, reals + AOV_NORMAL);
  store3(s->normal, reals + AOV_GEO_NORMAL);
  store3(s->position, reals + AOV_POSITION);
  reals[AOV_UV] = s->tex_u;
  reals[AOV_UV + 1] = s->tex_v;
  ints[AOV_SHAPE] = s->shape;
  ints[AOV_PRIMITIVE] = s->primitive;
}

#endif
