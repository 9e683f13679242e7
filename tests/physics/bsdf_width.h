// SPDX-License-Identifier: MIT
// The questions of bsdf_tiers.h at one width; no guard. Within the tier's namespace.
#include "lanes/lane_ops.h"
// Lanes come first: the other headers use their types and operations.
#include "math/vec3_lanes.h"
// Each needs what is above it.
#include "math/sampling_lanes.h"
// As above.
#include "rays/departing_lanes.h"
// As above.
#include "hits/surfaces_lanes.h"
// As above.
#include "textures/texture_lanes.h"
// As above.
#include "materials/material_lanes.h"

inline Bsdf_w LANED(bsdf_of)(int kind, const std::vector<double>& p, const Triad& wo) {
  Bsdf_w b{};
  b.kind = splat_int_w(kind);
  b.frame = frame_around_w(splat3_w(vec3(R(0.0), R(0.0), R(1.0))));
  coat_none_w(&b.coat);
  b.relief.which = none_w();
  b.relief.is_seen = ~none_w();
  b.relief.frame = b.frame;
  b.relief.base = b.frame.z;
  b.relief.fading = splat_w(R(0.0));
  b.wo = b.out = splat3_w(vec3((real)wo[0], (real)wo[1], (real)wo[2]));
  for (std::size_t i = 0; i < BSDF_REALS; ++i) b.p[i] = splat_w(i < p.size() ? (real)p[i] : R(0.0));
  return b;
}

/// Component k of as many as there are lanes, from i on; the last one fills the rest.
inline realw LANED(component_of)(const std::vector<Triad>& all, std::size_t i, std::size_t k) {
  realw a = splat_w(R(0.0));
  for (int lane = 0; lane < LANES; ++lane)
    put_w(&a, lane, (real)all[std::min(i + (std::size_t)lane, all.size() - 1)][k]);
  return a;
}

inline Triad LANED(lane_of)(const real3w& v, int lane) {
  return {get_w(&v.x, lane), get_w(&v.y, lane), get_w(&v.z, lane)};
}

inline std::vector<Scattered> LANED(eval_all)(int kind, const std::vector<double>& p, const Triad& wo,
                                              const std::vector<Triad>& wi) {
  const Bsdf_w b = LANED(bsdf_of)(kind, p, wo);
  std::vector<Scattered> found(wi.size());
  for (std::size_t i = 0; i < wi.size(); i += LANES) {
    realw density;
    const real3w towards =
        vec3_w(LANED(component_of)(wi, i, 0), LANED(component_of)(wi, i, 1), LANED(component_of)(wi, i, 2));
    const real3w value = bsdf_eval_w(&b, towards, &density);
    for (int lane = 0; lane < LANES && i + (std::size_t)lane < wi.size(); ++lane)
      found[i + (std::size_t)lane] = {LANED(lane_of)(value, lane), get_w(&density, lane)};
  }
  return found;
}

inline std::vector<Way> LANED(sample_all)(int kind, const std::vector<double>& p, const Triad& wo, int lobes,
                                          const std::vector<Triad>& numbers) {
  const Bsdf_w b = LANED(bsdf_of)(kind, p, wo);
  std::vector<Way> ways(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); i += LANES) {
    const BsdfSample_w s = bsdf_sample_w(&b, lobes, LANED(component_of)(numbers, i, 0),
                                         LANED(component_of)(numbers, i, 1), LANED(component_of)(numbers, i, 2));
    for (int lane = 0; lane < LANES && i + (std::size_t)lane < numbers.size(); ++lane)
      ways[i + (std::size_t)lane] = {LANED(lane_of)(s.wi, lane), LANED(lane_of)(s.weight, lane),
                                     get_w(&s.density, lane), get_w(&s.eta, lane), get_int_w(&s.lobe, lane)};
  }
  return ways;
}

inline std::vector<Triad> LANED(parameters_at)(const std::vector<Triad>& points) {
  // Red, green and the identity map for the texture; blue; rates of u and v: none, so nothing is filtered.
  const real shading[] = {1, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0};
  constexpr int blue = 12, rates = 15, texture = HEADER_INTS, part = texture + TEXTURE_INTS, rows = part + PART_INTS;
  int index[rows + 2 * MATERIAL_INTS] = {};
  index[HEADER_TEXTURES] = texture;
  index[texture + TEXTURE_KIND] = TEXTURE_checkerboard;
  index[HEADER_PARTS] = part;
  index[part + PART_UV_RATES] = rates;
  index[rows + MATERIAL_SLOTS + 1] = blue;
  index[rows + MATERIAL_INTS + MATERIAL_SLOTS + 1] = ~0;
  const Scene scene{nullptr, shading, index, nullptr, nullptr};
  std::vector<Triad> found(points.size());
  for (std::size_t i = 0; i < points.size(); i += LANES) {
    Surfaces_w s = surfaces_none_w();
    s.hit = ~s.hit;
    s.tex_u = LANED(component_of)(points, i, 0);
    s.tex_v = LANED(component_of)(points, i, 1);
    intw row = splat_int_w(rows);
    for (int lane = 0; lane < LANES; ++lane)
      if ((i + (std::size_t)lane) % 2 == 1) put_int_w(&row, lane, rows + MATERIAL_INTS);
    const real3w value = parameter_at_w(&scene, &s, s.hit, row, 1);
    for (int lane = 0; lane < LANES && i + (std::size_t)lane < points.size(); ++lane)
      found[i + (std::size_t)lane] = LANED(lane_of)(value, lane);
  }
  return found;
}
