// SPDX-License-Identifier: MIT
#define REAL_BITS 32
#include "physics/bsdf_body.h"

namespace strahl::test {

std::vector<BsdfEntry> bsdf_entries() {
  using namespace tier;
  return {
#define MATERIAL(name, reals, lobes) {#name, reals, lobes},
#include "materials/materials.def"
#undef MATERIAL
  };
}

std::vector<BsdfTier> bsdf_stable() {
  return {{"stable", 1, tier::eval_all_1, tier::sample_all_1, tier::parameters_at_1},
          {"stable", 8, tier::eval_all_8, tier::sample_all_8, tier::parameters_at_8},
          {"stable", 16, tier::eval_all_16, tier::sample_all_16, tier::parameters_at_16}};
}

}  // namespace strahl::test
