// SPDX-License-Identifier: MIT
#define REAL_BITS 32
#define TIER_ROBUST 1
#include "physics/bsdf_body.h"

namespace strahl::test {

std::vector<BsdfTier> bsdf_robust() {
  return {{"robust", 1, tier::eval_all_1, tier::sample_all_1, tier::parameters_at_1},
          {"robust", 8, tier::eval_all_8, tier::sample_all_8, tier::parameters_at_8},
          {"robust", 16, tier::eval_all_16, tier::sample_all_16, tier::parameters_at_16}};
}

}  // namespace strahl::test
