// SPDX-License-Identifier: MIT
// Dispatch over the active samplers, and the numbers that a sample draws by their use (samplers/uses.h). One width; no
// guard.
#include "samplers/sample_state_lanes.h"
#include "samplers/uses.h"
#include "samplers/all_lanes.h"

/// sequences: how many of them the numbers of a pixel's samples are divided into.
FN SampleState_w sequence_begin_w(const Scene* scene, uintw pixel, uintw sample, uint sequences) {
  SampleState_w state;
  state.pixel = pixel;
  state.sample = sample;
  state.seed = (uint)scene->index[HEADER_SEED];
  state.sequences = sequences;
  state.reversed = state.key = splat_uint_w(0u);
  switch (scene->index[HEADER_SAMPLER]) {
#define SAMPLER(name)       \
  case SAMPLER_##name:      \
    name##_begin_w(&state); \
    break;
#include "samplers/samplers.def"
#undef SAMPLER
    default:
      break;
  }
  return state;
}

FN SampleState_w sample_begin_w(const Scene* scene, uintw pixel, uintw sample) {
  return sequence_begin_w(scene, pixel, sample, (uint)scene->index[HEADER_SEQUENCES]);
}

FN Random2_w pair_of_set_w(const Scene* scene, const SampleState_w* state, uintw set) {
  Random2_w none;
  switch (scene->index[HEADER_SAMPLER]) {
#define SAMPLER(name)  \
  case SAMPLER_##name: \
    return name##_pair_w(state, set);
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
FN Random2_w sample_pair_w(const Scene* scene, const SampleState_w* state, int use) {
  return pair_of_set_w(scene, state, splat_uint_w((uint)use >> 1));
}

/// Both numbers of a use at the path's vertices; depth: surfaces before them.
FN Random2_w vertex_pair_w(const Scene* scene, const SampleState_w* state, intw depth, int use) {
  uintw first = uint_of_int_w(depth) * (uint)PAIRS_A_VERTEX;
  return pair_of_set_w(scene, state, first + ((uint)PAIRS_A_SAMPLE + ((uint)use >> 1)));
}

/// The one number of a use there.
FN uintw vertex_number_w(const Scene* scene, const SampleState_w* state, intw depth, int use) {
  Random2_w pair = vertex_pair_w(scene, state, depth, use);
  return (use & 1) == 0 ? pair.x : pair.y;
}
