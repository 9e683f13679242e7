// SPDX-License-Identifier: MIT
#include "settings/sampling.h"

#include "kinds/integrators.h"

namespace strahl {

ResolvedSampling resolve_sampling(const Scene& scene) {
  const SamplerSettings& stated = scene.sampler;
  // "auto" shows what path shows, edges included.
  const bool noiseless = kinds::integrator(scene.integrator.name).is_noiseless && scene.integrator.why.empty();
  // A stated sampler or more than one sample asks for antialiasing; otherwise one ray through each pixel's middle.
  const bool one_ray = noiseless && stated.sample_count.value_or(1) == 1;
  ResolvedSampling sampling{};
  sampling.kind = stated.kind.value_or(one_ray ? SamplerKind::centre : SamplerKind::sobol);
  sampling.spp = stated.sample_count.value_or(noiseless || sampling.kind == SamplerKind::centre ? 1 : 16);
  sampling.seed = static_cast<std::uint32_t>(stated.seed.value_or(0));
  return sampling;
}

}  // namespace strahl
