// SPDX-License-Identifier: MIT
// Independent random numbers: a hash of pixel, sample, set and seed (math/rng.h).
#ifndef STRAHL_SAMPLERS_INDEPENDENT_H
#define STRAHL_SAMPLERS_INDEPENDENT_H

#include "samplers/sample_state.h"

FN void independent_begin(SampleState* state) { state->key = 0u; }

FN Random2 independent_pair(const SampleState* state, uint set) {
  Random4 bits = random4(state->pixel, state->sample, set, state->seed);
  Random2 pair;
  pair.x = bits.x;
  pair.y = bits.y;
  return pair;
}

#endif
