// SPDX-License-Identifier: MIT
// Which samples a pixel gets.
#pragma once

#include <cstdint>

#include "scene/model/scene.h"

namespace strahl {

/// Samples per pixel, sampler and seed that a scene ends up with: what it states, or the integrator's default.
/// emission, depth, normals: centre, 1 sample; others: sobol, 16.
struct ResolvedSampling {
  SamplerKind kind;
  int spp;
  std::uint32_t seed;
};

[[nodiscard]] ResolvedSampling resolve_sampling(const Scene& scene);

/// What the film's words hold (cl/film/film_sum.h), whether in one sum or in four.
inline constexpr int max_spp = 1 << 21;

}  // namespace strahl
