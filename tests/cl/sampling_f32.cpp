// SPDX-License-Identifier: MIT
#define REAL_BITS 32
#include "cl/sampling_body.h"

namespace strahl::test {

Pair sobol_pair(std::uint32_t pixel, std::uint32_t sample, std::uint32_t set, std::uint32_t seed) {
  tier::SampleState state{pixel, sample, seed, 0, 0};
  tier::sobol_begin(&state);
  const tier::Random2 pair = tier::sobol_pair(&state, set);
  return {pair.x, pair.y};
}
Pair independent_pair(std::uint32_t pixel, std::uint32_t sample, std::uint32_t set, std::uint32_t seed) {
  tier::SampleState state{pixel, sample, seed, 0, 0};
  tier::independent_begin(&state);
  const tier::Random2 pair = tier::independent_pair(&state, set);
  return {pair.x, pair.y};
}

}  // namespace strahl::test
