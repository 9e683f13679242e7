// SPDX-License-Identifier: MIT
// Dispatch over the active samplers, and which set of numbers is for what: the same for a surface of a path whatever
// happened before it.
#ifndef STRAHL_SAMPLERS_SAMPLER_H
#define STRAHL_SAMPLERS_SAMPLER_H

#include "samplers/all.h"
#include "samplers/sample_state.h"
#include "scene/scene.h"

/// The place within the pixel; then for every surface of the path a light and a place on it, and the way on.
enum { SET_PIXEL, SET_LIGHT, SET_WAY, SETS_A_SURFACE = 2 };

FN uint set_at(int depth, int set) { return (uint)set + (uint)depth * (uint)SETS_A_SURFACE; }

FN SampleState sample_begin(const Scene* scene, uint pixel, uint sample) {
  SampleState state;
  state.pixel = pixel;
  state.sample = sample;
  state.seed = (uint)scene->index[HEADER_SEED];
  state.reversed = state.key = 0u;
  switch (scene->index[HEADER_SAMPLER]) {
#define SAMPLER(name)     \
  case SAMPLER_##name:    \
    name##_begin(&state); \
    break;
#include "samplers/samplers.def"
#undef SAMPLER
    default:
      break;
  }
  return state;
}

FN Random2 sample_pair(const Scene* scene, const SampleState* state, uint set) {
  Random2 none;
  switch (scene->index[HEADER_SAMPLER]) {
#define SAMPLER(name)  \
  case SAMPLER_##name: \
    return name##_pair(state, set);
#include "samplers/samplers.def"
#undef SAMPLER
    default:
      (void)state;
      (void)set;
      none.x = none.y = 0u;
      return none;
  }
}

/// One number that need not be spread evenly over the samples: whether a path goes on after `depth` surfaces.
FN uint roulette_number(const SampleState* state, int depth) {
  return random4(state->pixel, state->sample, ~(uint)depth, state->seed).x;
}

#endif
