// SPDX-License-Identifier: MIT
// Independent random numbers: a hash of pixel, sample, set and seed (math/rng_lanes.h).

FN void independent_begin_w(SampleState_w* state) { state->key = splat_uint_w(0u); }

FN Random2_w independent_pair_w(const SampleState_w* state, uintw set) {
  Random4_w bits = random4_w(state->pixel, state->sample, set, state->seed);
  Random2_w pair;
  pair.x = bits.x;
  pair.y = bits.y;
  return pair;
}
