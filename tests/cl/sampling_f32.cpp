// SPDX-License-Identifier: MIT
#define REAL_BITS 32
#include "cl/sampling_body.h"

namespace strahl::test {

namespace {

Pair sobol_of(std::uint32_t sequences, std::uint32_t pixel, std::uint32_t sample, std::uint32_t set,
              std::uint32_t seed) {
  tier::SampleState_w_1 state{pixel, sample, seed, sequences, 0, 0};
  tier::sobol_begin_w_1(&state);
  const tier::Random2_w_1 pair = tier::sobol_pair_w_1(&state, set);
  return {pair.x, pair.y};
}

}  // namespace

Pair sobol_pair(std::uint32_t pixel, std::uint32_t sample, std::uint32_t set, std::uint32_t seed) {
  return sobol_of(2, pixel, sample, set, seed);
}
Pair sobol_single_pair(std::uint32_t pixel, std::uint32_t sample, std::uint32_t set, std::uint32_t seed) {
  return sobol_of(1, pixel, sample, set, seed);
}
Pair independent_pair(std::uint32_t pixel, std::uint32_t sample, std::uint32_t set, std::uint32_t seed) {
  tier::SampleState_w_1 state{pixel, sample, seed, 1, 0, 0};
  tier::independent_begin_w_1(&state);
  const tier::Random2_w_1 pair = tier::independent_pair_w_1(&state, set);
  return {pair.x, pair.y};
}

}  // namespace strahl::test
