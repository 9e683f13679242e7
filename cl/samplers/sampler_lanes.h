// SPDX-License-Identifier: MIT
// Dispatch over the active samplers, and which set of numbers is for what: the same for a surface of a path whatever
// happened before it. One width; no guard.
#include "samplers/sample_state_lanes.h"
#include "samplers/all_lanes.h"

/// The place within the pixel; then for every surface of the path a light and a place on it, and the way on.
enum { SET_PIXEL, SET_LIGHT, SET_WAY, SETS_A_SURFACE = 2 };

FN uintw LANED(set_at)(intw depth, int set) { return uint_of_int_w(depth) * (uint)SETS_A_SURFACE + (uint)set; }

FN LANED(SampleState) LANED(sample_begin)(const Scene* scene, uint pixel, uintw sample) {
  LANED(SampleState) state;
  state.pixel = pixel;
  state.sample = sample;
  state.seed = (uint)scene->index[HEADER_SEED];
  state.sequences = (uint)scene->index[HEADER_SUMS];
  state.reversed = state.key = splat_uint_w(0u);
  switch (scene->index[HEADER_SAMPLER]) {
#define SAMPLER(name)            \
  case SAMPLER_##name:           \
    LANED(name##_begin)(&state); \
    break;
#include "samplers/samplers.def"
#undef SAMPLER
    default:
      break;
  }
  return state;
}

FN LANED(Random2) LANED(sample_pair)(const Scene* scene, const LANED(SampleState) * state, uintw set) {
  LANED(Random2) none;
  switch (scene->index[HEADER_SAMPLER]) {
#define SAMPLER(name)  \
  case SAMPLER_##name: \
    return LANED(name##_pair)(state, set);
#include "samplers/samplers.def"
#undef SAMPLER
    default:
      (void)state;
      (void)set;
      none.x = none.y = splat_uint_w(0u);
      return none;
  }
}

/// One number that need not be spread evenly over the samples: whether a path goes on after `depth` surfaces.
FN uintw LANED(roulette_number)(const LANED(SampleState) * state, intw depth) {
  return LANED(random4)(state->pixel, state->sample, ~uint_of_int_w(depth), state->seed).x;
}
