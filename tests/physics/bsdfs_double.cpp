// SPDX-License-Identifier: MIT
#define REAL_BITS 64
#include "physics/bsdf_body.h"

namespace strahl::test {

std::vector<BsdfTier> bsdf_double() {
  return {{"double", 1, tier::eval_all_1, tier::sample_all_1, tier::parameters_at_1},
          {"double", 8, tier::eval_all_8, tier::sample_all_8, tier::parameters_at_8}};
}

}  // namespace strahl::test
