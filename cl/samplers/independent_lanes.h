// SPDX-License-Identifier: MIT
// Independent random numbers: a hash of pixel, sample, set and seed (math/rng_lanes.h).

FN void LANED(independent_begin)(LANED(SampleState) * state) { state->key = splat_uint_w(0u); }

FN LANED(Random2) LANED(independent_pair)(const LANED(SampleState) * state, uintw set) {
  LANED(Random4) bits = LANED(random4)(state->pixel, state->sample, set, state->seed);
  LANED(Random2) pair;
  pair.x = bits.x;
  pair.y = bits.y;
  return pair;
}
