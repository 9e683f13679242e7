// SPDX-License-Identifier: MIT
// Dispatch over the active samplers, and the numbers that a sample draws by their use (samplers/uses.h). One width; no
// guard.
#include "samplers/sample_state_lanes.h"
#include "samplers/uses.h"
#include "samplers/all_lanes.h"

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

FN LANED(Random2) LANED(pair_of_set)(const Scene* scene, const LANED(SampleState) * state, uintw set) {
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

/// Both numbers of a use of the sample as a whole.
FN LANED(Random2) LANED(sample_pair)(const Scene* scene, const LANED(SampleState) * state, int use) {
  return LANED(pair_of_set)(scene, state, splat_uint_w((uint)use >> 1));
}

/// Both numbers of a use at the path's vertices; depth: surfaces before them.
FN LANED(Random2) LANED(vertex_pair)(const Scene* scene, const LANED(SampleState) * state, intw depth, int use) {
  uintw first = uint_of_int_w(depth) * (uint)PAIRS_A_VERTEX;
  return LANED(pair_of_set)(scene, state, first + ((uint)PAIRS_A_SAMPLE + ((uint)use >> 1)));
}

/// The one number of a use there.
FN uintw LANED(vertex_number)(const Scene* scene, const LANED(SampleState) * state, intw depth, int use) {
  LANED(Random2) pair = LANED(vertex_pair)(scene, state, depth, use);
  return (use & 1) == 0 ? pair.x : pair.y;
}
