// SPDX-License-Identifier: MIT
// Bands of flat shapes with corners.
#pragma once

#include "selftest/proof_parts.h"

namespace strahl::selftest {

/// closes: the growth of the band where the rounded corners do not form a parallelogram.
inline ExactAnswer answer_of_polygon(const Asked& q, const oracle::PlanarAnswer& met, int corners, double closes) {
  ExactAnswer answer = outside_band(met, met.cosine >= 1e-7 && std::fabs(met.margin) > 8 * u + closes);
  if (met.is_parallel) return answer;
  double scale = 0;  // how far the ray's origin is from the corners
  for (int i = 0; i < corners; ++i) scale = std::fmax(scale, length(at(q.planes + 3 * i) - q.ray.origin));
  if (!is_in_scale(scale)) answer.is_promised = false;
  const double away = 16 * u * scale / (met.cosine * length(q.ray.direction));
  for (const double bound : {0.0, q.ray.t_min, q.ray.t_max})
    if (std::fabs(met.t.value - bound) <= away) answer.is_promised = false;
  // A ray aimed at the edge may hit the neighbour instead, whose t there is within this band.
  if (!answer.is_promised) answer.t_rounding = away;
  return answer;
}

/// The stable forms fail only in the law `extreme`.
inline Promises promises_of_polygon() {
  using oracle::Law;
  return {0.5,
          1,
          {Law::aimed, Law::log_uniform, Law::border, Law::exact_border, Law::in_surface, Law::axis_parallel,
           Law::offset, Law::unnormalised}};
}

}  // namespace strahl::selftest
